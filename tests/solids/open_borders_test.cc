// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/open_borders.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

TEST(OpenBorders, OfAClosedComplexAreNone) {
  const OpenBorders none = open_borders(complex_of(unit_box()));
  EXPECT_EQ(none.sides + none.borders + none.near_sides + none.sheets, 0u);
}

TEST(OpenBorders, AreClassesOfOpenSidesByVertices) {
  Patches one_hole = unit_box();
  one_hole.pop_back();
  const OpenBorders lid = open_borders(complex_of(one_hole));
  EXPECT_EQ(lid.sides, 4u);
  EXPECT_EQ(lid.borders, 1u);
  EXPECT_EQ(lid.sheets, 1u);
  // Without two opposite faces a tube is left: box() has them in pairs.
  const Patches box = unit_box();
  const Patches tube(box.begin() + 2, box.end());
  const OpenBorders ends = open_borders(complex_of(tube));
  EXPECT_EQ(ends.sides, 8u);
  EXPECT_EQ(ends.borders, 2u);
  EXPECT_EQ(ends.sheets, 1u);
  const Patches far = patch_shapes::box({5, 5, 5}, {6, 6, 6});
  EXPECT_EQ(open_borders(complex_of(patch_shapes::joined({one_hole, far}))).sheets, 0u)
      << "a closed shell is no sheet";
  EXPECT_EQ(open_borders(complex_of(patch_shapes::joined({tube, {far[0]}}))).sheets, 2u);
  Patches turned = tube;
  turned[0] = reversed(turned[0]);
  EXPECT_EQ(open_borders(complex_of(turned)).sheets, 0u) << "directions are wrong, too";
}

// A face whose far corner is off by this much: two sides of it are cracks.
TEST(OpenBorders, NameTheDistancesOfCracks) {
  for (const int bits : {20, 52, 300}) {
    const Rational off = Rational::power_of_two(-bits);
    Patches box = unit_box();
    for (std::size_t i = 0; i < 4; ++i)
      if (box[5].tensor().component(0)[i] == Rational(1) &&
          box[5].tensor().component(1)[i] == Rational(1))
        box[5] = with_coefficient(box[5], 2, i, Rational(1) + off);
    const OpenBorders crack = open_borders(complex_of(box));
    EXPECT_EQ(crack.sides, 4u);
    EXPECT_EQ(crack.near_sides, 4u);
    EXPECT_EQ(crack.least, std::ldexp(1.0, -bits));
    EXPECT_EQ(crack.greatest, std::ldexp(1.0, -bits));
    // Far from the origin a gap of half a side is as wide as here.
    const Patches far = patch_shapes::placed(box, 1, {1000000, 0, 0});
    EXPECT_EQ(open_borders(complex_of(far)).greatest, std::ldexp(1.0, -bits));
  }
  Patches lifted = unit_box();
  lifted[5] = patch_shapes::placed({lifted[5]}, 1, {0, 0, Rational(1) / Rational(2)})[0];
  EXPECT_EQ(open_borders(complex_of(patch_shapes::placed(lifted, 1, {1000000, 0, 0}))).near_sides,
            0u);
  Patches box = unit_box();
  box[5] = with_coefficient(box[5], 2, 3, Rational(5) / Rational(4));
  EXPECT_EQ(open_borders(complex_of(box)).near_sides, 0u) << "a quarter is a hole";
}

}  // namespace
}  // namespace veritope
