// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/synthesis/cage_around.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "solids/micro/cage/box_cage.h"
#include "solids/micro/cage/radial_cage.h"
#include "tests/solids/cage_support.h"

namespace veritope {
namespace {

using namespace cage_test;

VModel box_around(const Rational& half) {
  return model_of({box_cage({at(-half, -half, -half), at(half, half, half)}, {}).value()});
}

TEST(FindEscape, ABallInABoxIsInsideHoweverTight) {
  for (const int bits : {1, 4, 8, 12})
    for (const auto& ball : {patch_shapes::sphere(), patch_shapes::octant_sphere()}) {
      const VModel cage = box_around(q(1) + Rational::power_of_two(-bits));
      EXPECT_FALSE(find_escape(cage, ball).value().has_value()) << bits;
    }
}

TEST(FindEscape, APatchThatLeavesIsNamedWithAPointOutside) {
  const auto ball = patch_shapes::sphere();
  const auto leaves = find_escape(box_around(q(9, 10)), ball).value();
  ASSERT_TRUE(leaves.has_value());
  EXPECT_LT(leaves->patch, ball.size());
  ASSERT_TRUE(leaves->point.has_value());
  bool is_out = false;
  Rational square;
  for (const Rational& x : *leaves->point) {
    is_out = is_out || x <= q(-9, 10) || x >= q(9, 10);
    square += x * x;
  }
  EXPECT_TRUE(is_out);
  EXPECT_EQ(square, q(1));
  // All of it is outside.
  const auto far = find_escape(box_around(q(1)), patch_shapes::placed(ball, q(1), {9, 0, 0}));
  ASSERT_TRUE(far.value().has_value());
  EXPECT_TRUE(far.value()->point.has_value());
}

TEST(FindEscape, ABallThatTouchesTheCageIsNotInside) {
  const auto touches = find_escape(box_around(q(1)), patch_shapes::octant_sphere()).value();
  EXPECT_TRUE(touches.has_value());
}

TEST(FindEscape, ARingIsNotAroundWhatFillsItsHole) {
  RadialShape shape;
  shape.inner = q(1);
  shape.outer = q(5);
  shape.low = q(-2);
  shape.high = q(2);
  const VModel ring = model_of({radial_cage(shape).value().cell});
  EXPECT_FALSE(find_escape(ring, patch_shapes::torus(3, 1)).value().has_value());
  EXPECT_TRUE(find_escape(ring, patch_shapes::placed(patch_shapes::sphere(), q(1, 2), {}))
                  .value()
                  .has_value());
}

TEST(CageContent, PartsOfPatchesAreCounted) {
  const auto ball = patch_shapes::sphere();
  const auto pn = patch_shapes::pn_torus(12, 8);
  for (const int rounds : {0, 1, 2, 3}) {
    EXPECT_EQ(content_of(ball, rounds).num_parts(),
              ball.size() * num_content_parts(ball[0], rounds));
    EXPECT_EQ(num_content_parts(ball[0], rounds), std::size_t{1} << 2 * rounds);
  }
  for (const int rounds : {2, 3})
    EXPECT_EQ(content_of(pn, rounds).num_parts(), pn.size() * num_content_parts(pn[0], rounds));
  EXPECT_EQ(num_content_parts(pn[0]), 1u);
}

}  // namespace
}  // namespace veritope
