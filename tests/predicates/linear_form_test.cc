// SPDX-License-Identifier: LGPL-3.0-or-later
// side_of_plane and compare_along.
#include <gtest/gtest.h>

#include "predicates/compare_along.h"
#include "predicates/side_of_plane.h"
#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

const double kTiny = 5e-324, kHuge = 0x1.fffffffffffffp1023;

TEST(SideOfPlane, IsPositiveWhereTheNormalPoints) {
  const PlaneCoefficients plane{{0, 0, 2}, -2};
  EXPECT_EQ(side_of_plane(plane, {5, 5, 3}), Sign::kPositive);
  EXPECT_EQ(side_of_plane(plane, {5, 5, 1}), Sign::kZero);
  EXPECT_EQ(side_of_plane(plane, {5, 5, 0}), Sign::kNegative);
}

TEST(SideOfPlane, TakesTheOffsetsSignForTheZeroNormal) {
  EXPECT_EQ(side_of_plane({{0, 0, 0}, 3}, {kHuge, 1, 1}), Sign::kPositive);
  EXPECT_EQ(side_of_plane({{0, 0, 0}, 0}, {kHuge, 1, 1}), Sign::kZero);
  EXPECT_EQ(side_of_plane({{0, -0.0, 0}, -kTiny}, {1, 1, 1}), Sign::kNegative);
}

TEST(SideOfPlane, IsExactWhereProductsUnderflowAndOverflow) {
  EXPECT_EQ(side_of_plane({{kTiny, 0, 0}, 0}, {kTiny, 0, 0}), Sign::kPositive);
  EXPECT_EQ(side_of_plane({{kHuge, -kHuge, kTiny}, 0}, {kHuge, kHuge, kTiny}), Sign::kPositive);
  EXPECT_EQ(side_of_plane({{kHuge, -kHuge, 0}, -kTiny}, {kHuge, kHuge, 1}), Sign::kNegative);
}

TEST(SideOfPlane, LeavesTinyValuesToTheExactTiers) {
  EXPECT_EQ(side_of_plane_filter({{0x1p-490, 0, 0}, 0}, {0x1p-490, 0, 0}), Sign3::kUncertain);
  EXPECT_EQ(side_of_plane({{0x1p-490, 0, 0}, 0}, {0x1p-490, 0, 0}), Sign::kPositive);
}

TEST(SideOfPlane, AsksEachTierOnlyAfterTheOneBefore) {
  const auto decide = [](PlaneCoefficients plane, Vec3d p) {
    return [=](TierCounts* tally) { return side_of_plane(plane, p, tally); };
  };
  expect_decided_by(Tier::kFilter, Sign::kPositive, decide({{1, 2, 3}, 4}, {1, 1, 1}));
  expect_decided_by(Tier::kLattice, Sign::kZero, decide({{1, 2, 3}, -6}, {1, 1, 1}));
  expect_decided_by(Tier::kInterval, Sign::kPositive,
                    decide({{0x1p-500, 0, 0}, 0}, {0x1p-500, 0x1p-600, 0}));
  expect_decided_by(Tier::kExact, Sign::kZero,
                    decide({{0.1, -0.1, 0}, 0}, {0x1.8p-70, 0x1.8p-70, 1}));
}

TEST(CompareAlong, IsPositiveForTheLaterPoint) {
  EXPECT_EQ(compare_along({1, 0, 0}, {2, 0, 0}, {1, 9, 9}), Sign::kPositive);
  EXPECT_EQ(compare_along({1, 0, 0}, {1, 0, 0}, {2, 9, 9}), Sign::kNegative);
  EXPECT_EQ(compare_along({1, 0, 0}, {1, 0, 0}, {1, 9, 9}), Sign::kZero);
  EXPECT_EQ(compare_along({0, 0, 0}, {1, 0, 0}, {2, 9, 9}), Sign::kZero);
}

TEST(CompareAlong, IsExactWhereProductsUnderflowAndOverflow) {
  EXPECT_EQ(compare_along({kTiny, 0, 0}, {kTiny, 0, 0}, {0, 0, 0}), Sign::kPositive);
  EXPECT_EQ(compare_along({kHuge, kHuge, kTiny}, {kHuge, -kHuge, kTiny}, {-kHuge, kHuge, 0}),
            Sign::kPositive);
}

TEST(CompareAlong, LeavesTinyValuesToTheExactTiers) {
  EXPECT_EQ(compare_along_filter({0x1p-490, 0, 0}, {0x1p-490, 0, 0}, {0, 0, 0}), Sign3::kUncertain);
  EXPECT_EQ(compare_along({0x1p-490, 0, 0}, {0x1p-490, 0, 0}, {0, 0, 0}), Sign::kPositive);
}

TEST(CompareAlong, AsksEachTierOnlyAfterTheOneBefore) {
  const auto decide = [](Vec3d d, Vec3d p, Vec3d q) {
    return [=](TierCounts* tally) { return compare_along(d, p, q, tally); };
  };
  expect_decided_by(Tier::kFilter, Sign::kPositive, decide({1, 2, 3}, {1, 1, 1}, {0, 0, 0}));
  expect_decided_by(Tier::kLattice, Sign::kZero, decide({1, 2, 3}, {1, 1, 1}, {6, 0, 0}));
  expect_decided_by(Tier::kInterval, Sign::kPositive,
                    decide({0x1p-500, 0, 0}, {0x1p-500, 0, 0}, {0x1p-600, 0, 0}));
  expect_decided_by(Tier::kExact, Sign::kZero,
                    decide({0.1, -0.1, 0}, {0x1.8p-70, 0x1.8p-70, 0}, {1, 1, 0}));
  // The direction alone can leave the lattice, too.
  expect_decided_by(Tier::kExact, Sign::kZero,
                    decide({0x1.8p-70, -0x1.8p-70, 1}, {0.1, 0.1, 1}, {3, 3, 1}));
}

}  // namespace
}  // namespace veritope
