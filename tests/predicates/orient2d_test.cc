// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient2d.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

using internal::orient2d_exact;
using internal::orient2d_interval;
using internal::orient2d_lattice;

TEST(Orient2d, IsPositiveForACounterClockwiseTriangle) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), Sign::kPositive);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), Sign::kNegative);
}

TEST(Orient2d, IsZeroForPointsOnALineAndForEqualPoints) {
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), Sign::kZero);
  EXPECT_EQ(orient2d({0.1, 0.7}, {0.1, 0.7}, {5, 1e300}), Sign::kZero);
  EXPECT_EQ(orient2d({0.0, 1}, {-0.0, 2}, {0.0, 1e-300}), Sign::kZero);
}

TEST(Orient2d, SeesOneUnitInTheLastPlace) {
  // The classic: 0.5 + k ulp on the line y = x.
  const double h = 0.5, up = 0.5 + 0x1p-53;
  EXPECT_EQ(orient2d({12, 12}, {24, 24}, {h, h}), Sign::kZero);
  EXPECT_EQ(orient2d({12, 12}, {24, 24}, {h, up}), Sign::kPositive);
  EXPECT_EQ(orient2d({12, 12}, {24, 24}, {up, h}), Sign::kNegative);
}

TEST(Orient2d, IsExactWhereProductsUnderflowAndOverflow) {
  const double tiny = 5e-324, huge = 0x1.fffffffffffffp1023;
  EXPECT_EQ(orient2d({0, 0}, {tiny, 0}, {0, tiny}), Sign::kPositive);
  EXPECT_EQ(orient2d({0, 0}, {tiny, tiny}, {2 * tiny, 2 * tiny}), Sign::kZero);
  EXPECT_EQ(orient2d({-huge, -huge}, {huge, -huge}, {-huge, huge}), Sign::kPositive);
  EXPECT_EQ(orient2d({-huge, -huge}, {huge, huge}, {tiny, 0}), Sign::kNegative);
  EXPECT_EQ(orient2d({-huge, -huge}, {huge, huge}, {0, tiny}), Sign::kPositive);
}

TEST(Orient2d, IsNotMisledByProductsThatUnderflowToDifferentSides) {
  // left rounds up to 2^-1074 and right down to 0, while the differences' roundings hide that right
  // is the larger: kAbs pays.
  const Vec2d a{0x1p-554, 0x1p-627}, b{0x1p-500, -0x1p-574}, c{-0x1p-501, 0x1.0000000000002p-575};
  EXPECT_EQ(orient2d_filter(a, b, c), Sign3::kUncertain);
  EXPECT_EQ(orient2d(a, b, c), Sign::kNegative);
  EXPECT_EQ(orient2d_filter({0, 0}, {0x1p-490, 0}, {0, 0x1p-490}), Sign3::kUncertain);
}

TEST(Orient2d, AsksEachTierOnlyAfterTheOneBefore) {
  const auto decide = [](Vec2d a, Vec2d b, Vec2d c) {
    return [=](TierCounts* tally) { return orient2d(a, b, c, tally); };
  };
  expect_decided_by(Tier::kFilter, Sign::kPositive, decide({0, 0}, {1, 0}, {0, 1}));
  expect_decided_by(Tier::kLattice, Sign::kZero, decide({0.5, 0.5}, {12, 12}, {24, 24}));
  expect_decided_by(Tier::kLattice, Sign::kZero, decide({0x1p-70, 0x1p-70}, {1, 1}, {3, 3}));
  expect_decided_by(Tier::kLattice, Sign::kZero, decide({0x1p-300, 1}, {1, 0.3}, {0x1p-300, 1}));
  // Exponents that span more than 124 bits, or too small ones for the lattice; the products are far
  // below the filter's absolute term, not below each other.
  expect_decided_by(Tier::kInterval, Sign::kPositive,
                    decide({0x1p-650, 0}, {0x1p-500, 0}, {0, 0x1p-500}));
  expect_decided_by(Tier::kExact, Sign::kZero, decide({0x1p-900, 0x1p-900}, {1, 1}, {3, 3}));
}

TEST(Orient2d, DecidesLinesAlongAnAxisAndEqualPointsBeforeTheLattice) {
  // No lattice of one or two limbs holds these coordinates: the tier can only have decided by a zero
  // column or row.
  const double tiny = 5e-324, huge = 0x1.fffffffffffffp1023;
  const auto decide = [](Vec2d a, Vec2d b, Vec2d c) {
    return [=](TierCounts* tally) { return orient2d(a, b, c, tally); };
  };
  for (const double level : {0.0, -0.0, tiny, -0.1, huge, -huge}) {
    expect_decided_by(Tier::kLattice, Sign::kZero,
                      decide({level, tiny}, {level, huge}, {level, 0.3}));
    expect_decided_by(Tier::kLattice, Sign::kZero,
                      decide({tiny, level}, {huge, level}, {0.3, level}));
    expect_decided_by(Tier::kLattice, Sign::kZero,
                      decide({tiny, level}, {tiny, level}, {0.3, huge}));
  }
}

TEST(Orient2d, IsExactNextToALineAlongAnAxis) {
  // Two points at one height, the third off it by the least step: products underflow or overflow.
  const double tiny = 5e-324, huge = 0x1.fffffffffffffp1023;
  for (const double level : {0.0, tiny, 0.1, -0.3, 0x1p-1022, 0x1p970, std::nextafter(huge, 0)}) {
    const double above = std::nextafter(level, huge);
    for (const double left : {-huge, -1.0, 0.0, -tiny}) {
      for (const double right : {tiny, 0.7, huge}) {
        const Vec2d a{left, level}, b{right, level}, c{right, above}, d{left, above};
        EXPECT_EQ(orient2d(a, b, c), Sign::kPositive) << level << ' ' << left << ' ' << right;
        EXPECT_EQ(orient2d(b, a, d), Sign::kNegative) << level << ' ' << left << ' ' << right;
        EXPECT_EQ(orient2d({level, left}, {level, right}, {above, right}), Sign::kNegative);
        EXPECT_EQ(orient2d({level, right}, {level, left}, {above, right}), Sign::kPositive);
        EXPECT_EQ(orient2d(a, a, c), Sign::kZero);
        EXPECT_EQ(orient2d(a, c, a), Sign::kZero);
        EXPECT_EQ(orient2d(c, a, a), Sign::kZero);
      }
    }
  }
}

TEST(Orient2d, TakesZerosOfEitherSignForOneNumber) {
  for (const int signs : {0, 1, 2, 3, 4, 5, 6, 7}) {
    const auto zero = [&](int bit) { return (signs >> bit & 1) != 0 ? -0.0 : 0.0; };
    EXPECT_EQ(orient2d({0.1, zero(0)}, {0.7, zero(1)}, {-3, zero(2)}), Sign::kZero) << signs;
    EXPECT_EQ(orient2d({zero(0), 0.1}, {zero(1), 0.7}, {zero(2), -3}), Sign::kZero) << signs;
    EXPECT_EQ(orient2d({zero(0), zero(1)}, {zero(2), -0.0}, {1, 5e-324}), Sign::kZero) << signs;
    EXPECT_EQ(orient2d({zero(0), zero(1)}, {1, zero(2)}, {1, 5e-324}), Sign::kPositive) << signs;
  }
}

TEST(Orient2d, FilterIsUncertainWhereADifferenceOverflows) {
  const double most = 0x1.fffffffffffffp1023;
  // b.y - a.y overflows, times a small c.x - a.x; the other product is larger, or smaller.
  for (const double small : {0x1p-1000, -0x1p-1000}) {
    for (const double other : {0x1p-30, -0x1p-30, 0x1p60, -0x1p60, 1e308, -1e308}) {
      const Vec2d a{0, -most}, b{other, most}, c{small, 0x1p970 - most};
      EXPECT_TRUE(orient2d_filter(a, b, c) == Sign3::kUncertain) << small << ' ' << other;
      EXPECT_EQ(orient2d(a, b, c), orient2d_exact(a, b, c));
    }
  }
}

TEST(Orient2d, ProductsOfOppositeSignsDoNotCancel) {
  EXPECT_EQ(orient2d_filter({0, 0}, {1, -1}, {1, 1}), Sign3::kPositive);
  EXPECT_EQ(orient2d_filter({0, 0}, {1, 1}, {1, -1}), Sign3::kNegative);
  EXPECT_EQ(orient2d_filter({0, 0}, {0x1p511, -0x1p512}, {0x1p511, 0x1p511}), Sign3::kPositive);
  EXPECT_EQ(orient2d_filter({0, 0}, {0x1p-460, -0x1p-460}, {0x1p-460, 0x1p-460}),
            Sign3::kUncertain);
}

TEST(Orient2d, TiersSayUncertainRatherThanGuess) {
  const double huge = 0x1.fffffffffffffp1023;
  EXPECT_EQ(orient2d_filter({0, 0}, {1, 1}, {3, 3}), Sign3::kUncertain);
  EXPECT_EQ(orient2d_filter({-huge, -huge}, {huge, -huge}, {-huge, huge}), Sign3::kUncertain);
  EXPECT_EQ(orient2d_filter({0, 0}, {5e-324, 0}, {0, 5e-324}), Sign3::kUncertain);
  EXPECT_EQ(orient2d_lattice({0x1p-125, 0}, {1, 1}, {3, 3}), Sign3::kUncertain);
  EXPECT_EQ(orient2d_interval({0.1, 0.1}, {1, 1}, {3, 3}), Sign3::kUncertain);
}

TEST(Orient2d, LatticeAndIntegersAgreeWhereBothAnswer) {
  EXPECT_EQ(orient2d_exact({0x1p-64, 0x1p-64}, {1, 1}, {3, 3}), Sign::kZero);
  EXPECT_EQ(orient2d_lattice({0x1p-64, 0x1p-64}, {1, 1}, {3, 3}), Sign3::kZero);  // two limbs
  EXPECT_EQ(orient2d_exact({0x1p-900, 0x1p-901}, {1, 1}, {3, 3}), Sign::kNegative);
}

}  // namespace
}  // namespace veritope
