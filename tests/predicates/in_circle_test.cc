// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/in_circle.h"

#include <gtest/gtest.h>

#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

using internal::in_circle_exact;
using internal::in_circle_interval;
using internal::in_circle_lattice;

const Vec2d kEast{1, 0}, kNorth{0, 1}, kWest{-1, 0};

TEST(InCircle, IsPositiveInsideZeroOnAndNegativeOutsideOfACounterClockwiseCircle) {
  EXPECT_EQ(in_circle(kEast, kNorth, kWest, {0, 0}), Sign::kPositive);
  EXPECT_EQ(in_circle(kEast, kNorth, kWest, {0, -1}), Sign::kZero);
  EXPECT_EQ(in_circle(kEast, kNorth, kWest, {0, -2}), Sign::kNegative);
  EXPECT_EQ(in_circle(kWest, kNorth, kEast, {0, 0}), Sign::kNegative);
}

TEST(InCircle, IsZeroForPointsOnALineAndForEqualPointsOnly) {
  EXPECT_EQ(in_circle({0, 0}, {1, 1}, {2, 2}, {5, 5}), Sign::kZero);
  EXPECT_EQ(in_circle(kEast, kEast, kWest, {0.3, 0.4}), Sign::kZero);
  EXPECT_EQ(in_circle(kEast, kNorth, kWest, kNorth), Sign::kZero);
  EXPECT_NE(in_circle({0, 0}, {1, 1}, {2, 2}, {5, 6}), Sign::kZero);
}

TEST(InCircle, SeesOneUnitInTheLastPlace) {
  EXPECT_EQ(in_circle(kEast, kNorth, kWest, {0x1.3333333333333p-1, -0x1.999999999999ap-1}),
            Sign::kNegative);  // 0.6, -0.8
  EXPECT_EQ(in_circle({5, 0}, {0, 5}, {-5, 0}, {3, -4}), Sign::kZero);
  EXPECT_EQ(in_circle({5, 0}, {0, 5}, {-5, 0}, {3, -0x1.0000000000001p2}), Sign::kNegative);
  EXPECT_EQ(in_circle({5, 0}, {0, 5}, {-5, 0}, {3, -0x1.fffffffffffffp1}), Sign::kPositive);
}

TEST(InCircle, IsExactWhereProductsUnderflowAndOverflow) {
  const double tiny = 5e-324, huge = 0x1.fffffffffffffp1023;
  EXPECT_EQ(in_circle({tiny, 0}, {0, tiny}, {-tiny, 0}, {0, 0}), Sign::kPositive);
  EXPECT_EQ(in_circle({tiny, 0}, {0, tiny}, {-tiny, 0}, {0, -tiny}), Sign::kZero);
  EXPECT_EQ(in_circle({huge, 0}, {0, huge}, {-huge, 0}, {0, -huge}), Sign::kZero);
  EXPECT_EQ(in_circle({huge, 0}, {0, huge}, {-huge, 0}, {tiny, -huge}), Sign::kNegative);
}

TEST(InCircle, IsNotMisledByAMinorThatUnderflowsAndIsThenMadeLarge) {
  // As for orient3d: minors of 0.4 and -0.6 units, lifts of 1.6 and 1 times 2^1000.
  const Vec2d a{0.6, 0x1.43d136248490fp500}, b{0.4, 0x1p500}, c{0, 5e-324}, d{0, 0};
  EXPECT_EQ(in_circle_filter(a, b, c, d), Sign3::kUncertain);
  EXPECT_EQ(in_circle(a, b, c, d), Sign::kPositive);
  EXPECT_EQ(in_circle_filter({0x1p-240, 0}, {0, 0x1p-240}, {-0x1p-240, 0}, {0, 0}),
            Sign3::kUncertain);
}

TEST(InCircle, AsksEachTierOnlyAfterTheOneBefore) {
  const auto decide = [](Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
    return [=](TierCounts* tally) { return in_circle(a, b, c, d, tally); };
  };
  expect_decided_by(Tier::kFilter, Sign::kPositive, decide(kEast, kNorth, kWest, {0, 0}));
  expect_decided_by(Tier::kLattice, Sign::kZero, decide(kEast, kNorth, kWest, {0, -1}));
  expect_decided_by(Tier::kInterval, Sign::kPositive,
                    decide({0x1p-235, 0}, {0, 0x1p-235}, {-0x1p-235, 0}, {0x1p-380, 0x1p-380}));
  expect_decided_by(Tier::kLattice, Sign::kNegative, decide(kEast, kNorth, kWest, {0x1p-70, -1}));
  expect_decided_by(Tier::kLattice, Sign::kZero,
                    decide({0.1, 5}, {0.1, 0.7}, {0x1p-800, 5}, {0.1, 5}));
  expect_decided_by(Tier::kLattice, Sign::kZero,
                    decide({0.1, 5}, {0x1p-700, 0.3}, {7, 0.9}, {0.1, 5}));
  expect_decided_by(Tier::kExact, Sign::kNegative, decide(kEast, kNorth, kWest, {0x1p-700, -1}));
}

TEST(InCircle, TiersSayUncertainRatherThanGuess) {
  const double huge = 0x1.fffffffffffffp1023;
  EXPECT_EQ(in_circle_filter(kEast, kNorth, kWest, {0, -1}), Sign3::kUncertain);
  EXPECT_EQ(in_circle_filter({huge, 0}, {0, huge}, {-huge, 0}, {0, 0}), Sign3::kUncertain);
  EXPECT_EQ(in_circle_lattice(kEast, kNorth, kWest, {0x1p-125, 0}), Sign3::kUncertain);
  EXPECT_EQ(in_circle_interval({0.3, 0.4}, {-0.3, 0.4}, {-0.3, -0.4}, {0.3, -0.4}),
            Sign3::kUncertain);
}

TEST(InCircle, WideLatticeAndIntegersAgree) {
  EXPECT_EQ(in_circle_exact(kEast, kNorth, kWest, {0x1p-70, 0}), Sign::kPositive);
  EXPECT_EQ(in_circle_exact(kEast, kNorth, kWest, {0x1p-700, -1}), Sign::kNegative);
}

}  // namespace
}  // namespace veritope
