// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/side_of_bisector.h"

#include <gtest/gtest.h>

namespace veritope {
namespace {

TEST(SideOfBisector, IsPositiveOnTheSideOfTheFirstPoint) {
  const Vec2d a{0, 0}, b{2, 0};
  EXPECT_EQ(side_of_bisector2d(a, b, {0.5, 9}), Sign::kPositive);
  EXPECT_EQ(side_of_bisector2d(a, b, {1, 9}), Sign::kZero);
  EXPECT_EQ(side_of_bisector2d(a, b, {0x1.0000000000001p+0, 9}), Sign::kNegative);
  EXPECT_EQ(side_of_bisector2d(b, a, {0.5, 9}), Sign::kNegative);
  EXPECT_EQ(side_of_bisector2d({5, 5}, {5, 5}, {1, 2}), Sign::kZero);
  EXPECT_EQ(side_of_bisector2d({0, 0}, {0x1p-1074, 0}, {0, 0}), Sign::kPositive);
  EXPECT_EQ(side_of_bisector3d({0, 0, 0}, {0, 0, 2}, {7, -7, 0x1.fffffffffffffp-1}),
            Sign::kPositive);
  EXPECT_EQ(side_of_bisector3d({0, 0, 0}, {0, 0, 2}, {7, -7, 1}), Sign::kZero);
}

TEST(SideOfBisector, CountsTheTierThatDecided) {
  TierCounts tally;
  side_of_bisector2d({0, 0}, {2, 0}, {0.5, 9}, &tally);
  side_of_bisector3d({0, 0, 0}, {0, 0, 2}, {7, -7, 1}, &tally);
  EXPECT_EQ(tally[Tier::kFilter], 1u);
  EXPECT_EQ(tally[Tier::kLattice], 1u);
}

}  // namespace
}  // namespace veritope
