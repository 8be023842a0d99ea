// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient3d.h"

#include <gtest/gtest.h>

#include "tests/predicates/point_generators.h"
#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

using internal::orient3d_exact;
using internal::orient3d_interval;
using internal::orient3d_lattice;

const Vec3d kO{0, 0, 0}, kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

TEST(Orient3d, IsPositiveForTheUnitVectorsInOrder) {
  EXPECT_EQ(orient3d(kO, kX, kY, kZ), Sign::kPositive);
  EXPECT_EQ(orient3d(kX, kO, kY, kZ), Sign::kNegative);
}

TEST(Orient3d, IsZeroForPointsOnAPlane) {
  EXPECT_EQ(orient3d(kO, kX, kY, {7, -3, 0}), Sign::kZero);
  EXPECT_EQ(orient3d({0.1, 0.2, 0.3}, {0.3, 0.2, 0.9}, {0.7, 0.2, 0.1}, {0.4, 0.2, 1e-300}),
            Sign::kZero);
  EXPECT_EQ(orient3d({1, 2, 3}, {1, 2, 3}, kY, kZ), Sign::kZero);
  EXPECT_EQ(orient3d({0.0, 1, 2}, {-0.0, 1, 5}, {0.0, 7, 2}, {-0.0, 1e300, 1e-300}), Sign::kZero);
}

TEST(Orient3d, SeesOneUnitInTheLastPlace) {
  const Vec3d a{12, 12, 12}, b{24, 24, 24}, c{0.5, 0.5, 0.25};
  EXPECT_EQ(orient3d(a, b, c, {0.5, 0.5, 0.5}), Sign::kZero);
  const Sign up = orient3d(a, b, c, {0.5, 0.5 + 0x1p-53, 0.5});
  EXPECT_NE(up, Sign::kZero);
  EXPECT_EQ(orient3d(a, b, c, {0.5 + 0x1p-53, 0.5, 0.5}), -up);
}

TEST(Orient3d, IsExactWhereProductsUnderflowAndOverflow) {
  const double tiny = 5e-324, huge = 0x1.fffffffffffffp1023;
  EXPECT_EQ(orient3d(kO, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}), Sign::kPositive);
  EXPECT_EQ(orient3d({-huge, 0, 0}, {huge, 0, 0}, {0, huge, 0}, {0, 0, tiny}), Sign::kPositive);
  EXPECT_EQ(orient3d({-huge, -huge, -huge}, {huge, -huge, -huge}, {-huge, huge, -huge},
                     {-huge, -huge, huge}),
            Sign::kPositive);
  // The minor underflows, and is then multiplied by something huge: a lower limit on the
  // determinant alone is not enough.
  EXPECT_EQ(
      orient3d(kO, {0x1p-540, 0x1.8p-540, 0}, {0x1p-540, 0x1.8000000000001p-540, 0}, {0, 0, huge}),
      Sign::kPositive);
}

TEST(Orient3d, IsNotMisledByAMinorThatUnderflowsAndIsThenMadeLarge) {
  // The minors are 0.4 and -0.6 units of 2^-1074, computed as 0 and -1; the last point weighs them
  // with 1.6 and 1: kEta pays.
  const Vec3d b{0x1.8p-537, 0x1p-537, 0}, c{0, 0, 0x1.999999999999ap-539},
      d{0x1.999999999999ap1000, 0x1p1000, 0};
  EXPECT_EQ(orient3d_filter(kO, b, c, d), Sign3::kUncertain);
  EXPECT_EQ(orient3d(kO, b, c, d), Sign::kPositive);
  EXPECT_EQ(orient3d_filter(kO, {0x1p-330, 0, 0}, {0, 0x1p-330, 0}, {0, 0, 0x1p-330}),
            Sign3::kUncertain);
}

TEST(Orient3d, AsksEachTierOnlyAfterTheOneBefore) {
  const auto decide = [](Vec3d a, Vec3d b, Vec3d c, Vec3d d) {
    return [=](TierCounts* tally) { return orient3d(a, b, c, d, tally); };
  };
  expect_decided_by(Tier::kFilter, Sign::kPositive, decide(kO, kX, kY, kZ));
  expect_decided_by(Tier::kLattice, Sign::kZero, decide(kX, kY, kZ, {3, -1, -1}));
  expect_decided_by(Tier::kLattice, Sign::kZero,
                    decide({0.1, 0.2, 1}, {0.7, 0x1p-80, 1}, {1e300, 5, 1}, {8, 8, 1}));
  expect_decided_by(Tier::kInterval, Sign::kPositive,
                    decide({0x1p-480, 0, 0}, {0x1p-320, 0, 0}, {0, 0x1p-320, 0}, {0, 0, 0x1p-321}));
  expect_decided_by(Tier::kLattice, Sign::kZero,
                    decide({0x1p-70, 0, 0}, {1, 1, 1}, {0, 3, 3}, {0, 5, 5}));
  expect_decided_by(Tier::kExact, Sign::kZero,
                    decide({0x1p-900, 0, 0}, {1, 1, 1}, {0, 3, 3}, {0, 5, 5}));
}

TEST(Orient3d, TiersSayUncertainRatherThanGuess) {
  const double huge = 0x1.fffffffffffffp1023;
  EXPECT_EQ(orient3d_filter(kX, kY, kZ, {3, -1, -1}), Sign3::kUncertain);
  EXPECT_EQ(orient3d_filter(kO, {huge, 0, 0}, {0, huge, 0}, {0, 0, huge}), Sign3::kUncertain);
  EXPECT_EQ(orient3d_filter(kO, {0x1p-480, 0, 0}, {0, 0x1p-480, 0}, {0, 0, 1}), Sign3::kUncertain);
  EXPECT_EQ(orient3d_lattice({0x1p-125, 0, 0}, kX, kY, kZ), Sign3::kUncertain);
  EXPECT_EQ(orient3d_lattice(kX, {0, 0x1p-125, 0}, kY, kZ), Sign3::kUncertain);
  EXPECT_EQ(orient3d_lattice(kX, kY, {0, 0, 0x1p-125}, kZ), Sign3::kUncertain);
  EXPECT_EQ(orient3d_interval({0.1, 0, 0}, {1, 1, 1}, {0.1, 3, 3}, {0.1, 5, 5}), Sign3::kUncertain);
}

TEST(Orient3d, WideLatticeAndIntegersAgree) {
  EXPECT_EQ(orient3d_lattice({0x1p-64, 0, 0}, kX, kY, kZ), Sign3::kPositive);  // two limbs
  EXPECT_EQ(orient3d_exact({0x1p-64, 0, 0}, kX, kY, kZ), Sign::kPositive);
  EXPECT_EQ(orient3d_exact({0x1p-64, 0, 0}, {0, 0x1p-900, 0}, kY, kZ), Sign::kNegative);
}

TEST(Orient3dPlaneFilter, IsTheFilterBitForBit) {
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
      const generate::Points p = generate::points(static_cast<generate::Kind>(kind), random);
      const Orient3dPlaneFilter plane(p[0], p[1], p[2]);
      EXPECT_EQ(plane(p[3]), orient3d_filter(p[0], p[1], p[2], p[3]));
      EXPECT_EQ(plane(p[4]), orient3d_filter(p[0], p[1], p[2], p[4]));
    }
  }
}

}  // namespace
}  // namespace veritope
