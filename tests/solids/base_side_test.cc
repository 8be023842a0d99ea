// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/base_side.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "tests/solids/literal_support.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using literal::fraction;
using literal::monomial;
using literal::moved;

// Over (0,0,0), (1,0,0), (0,1,0).
BaseSide side_of_height(const literal::Poly& height) {
  return base_side(moved({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0, 1}, height}}));
}

TEST(BaseSide, IsThatOfThePatchAndNotOfItsControlPoints) {
  EXPECT_EQ(side_of_height(monomial({1, 1, 0})), BaseSide::kPlus);
  EXPECT_EQ(side_of_height(monomial({1, 1, 0}, Rational(-1))), BaseSide::kMinus);
  EXPECT_EQ(side_of_height(monomial({1, 1, 0}, Rational(0))), BaseSide::kZero);
  EXPECT_EQ(side_of_height(monomial({2, 1, 0}) + monomial({1, 2, 0}, Rational(-1))),
            BaseSide::kMixed);
  // u v ((u - v)^2 + 1/20): a coefficient is negative.
  const auto uv = monomial({1, 1, 0}), unit = literal::unit();
  const auto positive =
      uv * (monomial({2, 0, 0}) + monomial({1, 1, 0}, Rational(-2)) + monomial({0, 2, 0}) +
            unit * unit * literal::Poly{0, {{{0, 0, 0}, fraction(1, 20)}}});
  EXPECT_TRUE(literal::bernstein(positive, 2, 2, 0).sign() < 0);
  EXPECT_EQ(side_of_height(positive), BaseSide::kPlus);
}

// (u - 2 v)^2 u v is nowhere negative, but coefficients are, however small the pieces.
TEST(BaseSide, IsOpenWhereAPatchOnlyTouchesItsBase) {
  EXPECT_EQ(side_of_height(monomial({3, 1, 0}) + monomial({2, 2, 0}, Rational(-4)) +
                           monomial({1, 3, 0}, Rational(4))),
            BaseSide::kOpen);
}

TEST(BaseSide, WithoutAnAreaIsOpen) {
  EXPECT_EQ(
      base_side(moved({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, {{{0, 0, 1}, monomial({1, 1, 1})}})),
      BaseSide::kOpen);
}

TEST(BaseSide, OfPatchesWithFourSides) {
  BaseSideCounts counts;
  for (const Patch& patch : patch_shapes::octant_sphere()) counts.add(base_side(patch));
  EXPECT_EQ(counts.plus, 8u);
  BaseSideCounts flat;
  for (const Patch& patch : unit_box()) flat.add(base_side(patch));
  EXPECT_EQ(flat.zero, 6u);
  // A saddle over the lower diagonal of its corners.
  const Patch saddle = bilinear({PatchPoint{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}});
  EXPECT_EQ(base_side(saddle), BaseSide::kPlus);
  EXPECT_EQ(base_side(reversed(saddle)), BaseSide::kMinus);
}

}  // namespace
}  // namespace veritope
