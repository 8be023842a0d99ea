// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_place.h"

#include <gtest/gtest.h>

#include "tests/solids/patch_support.h"
#include "verify/certify/meeting_witness.h"

namespace veritope {
namespace {

Rational ratio(int n, int d) { return Rational(n) / Rational(d); }

// The places of all patches at these parameters.
std::vector<PatchPlace> places_at(const PatchComplex& complex,
                                  const std::vector<Rational>& parameters) {
  std::vector<PatchPlace> out;
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    for (const Rational& s : parameters)
      for (const Rational& t : parameters) out.push_back({p, {s, t}});
  return out;
}

Patches octahedron() {
  const PatchPoint corners[6] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                 {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  Patches out;
  for (const auto& [a, b, c] :
       {std::array{0, 2, 4}, std::array{2, 1, 4}, std::array{1, 3, 4}, std::array{3, 0, 4},
        std::array{2, 0, 5}, std::array{1, 2, 5}, std::array{3, 1, 5}, std::array{0, 3, 5}})
    out.push_back(flat(corners[a], corners[b], corners[c]));
  return out;
}

// Law: in an embedded model two places are one point of the surface iff they have one image.
TEST(PatchPlace, IsOnePointWhereTheImageOfAnEmbeddedModelIs) {
  const std::vector<Rational> parameters = {0, ratio(1, 3), ratio(1, 2), ratio(2, 3), 1};
  for (const Patches& patches :
       {unit_box(), octahedron(), patch_shapes::sphere(), patch_shapes::octant_sphere(),
        patch_shapes::torus(3, 1), patch_shapes::one_patch_torus(3, 1),
        patch_shapes::frustum(1, 0, 2)}) {
    for (const bool is_back : {false, true}) {
      const PatchComplex complex = complex_of(is_back ? patch_shapes::reversed(patches) : patches);
      ASSERT_TRUE(is_glued(complex));
      const std::vector<PatchPlace> places = places_at(complex, parameters);
      std::vector<PatchPoint> images;
      for (const PatchPlace& p : places) images.push_back(point_of(complex, p));
      for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
          ASSERT_EQ(are_one_point(complex, places[i], places[j]), images[i] == images[j])
              << i << " " << j << " of " << patches.size() << " patches";
    }
  }
}

// Copies of a shell in one place are other points of the surface.
TEST(PatchPlace, OfAnotherShellIsAnotherPoint) {
  const PatchComplex complex =
      complex_of(patch_shapes::joined({unit_box(), patch_shapes::box({1, 1, 1}, {2, 2, 2})}));
  ASSERT_TRUE(is_glued(complex));
  std::size_t num_common = 0;
  const std::vector<PatchPlace> places = places_at(complex, {0, 1});
  for (const PatchPlace& a : places)
    for (const PatchPlace& b : places) {
      if (a.patch >= 6 || b.patch < 6) continue;
      EXPECT_FALSE(are_one_point(complex, a, b));
      num_common += point_of(complex, a) == point_of(complex, b) ? 1 : 0;
    }
  EXPECT_EQ(num_common, 9u);  // three corners of faces of each
}

TEST(PatchPlace, IsKnownOnlyOfClosedOrientedSurfaces) {
  Patches open = unit_box();
  open.pop_back();
  EXPECT_FALSE(is_glued(complex_of(open)));
  Patches turned = unit_box();
  turned[0] = reversed(turned[0]);
  EXPECT_FALSE(is_glued(complex_of(turned)));
  EXPECT_TRUE(is_glued(complex_of(unit_box())));
}

}  // namespace
}  // namespace veritope
