// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/binomial.h"

#include <gtest/gtest.h>

#include "robust/base/check.h"

namespace veritope {
namespace {

TEST(Binomial, IsPascalsTriangleUpToRow140) {
  std::vector<Integer> row{Integer(1)};
  for (int n = 0; n <= 140; ++n) {
    for (int k = 0; k <= n; ++k)
      ASSERT_EQ(binomial(n, k), row[static_cast<std::size_t>(k)]) << n << " over " << k;
    row.push_back(Integer(0));
    for (std::size_t k = row.size() - 1; k > 0; --k) row[k] += row[k - 1];
  }
}

TEST(Binomial, IsZeroOutsideOfTheTriangle) {
  EXPECT_EQ(binomial(5, -1), Integer(0));
  EXPECT_EQ(binomial(5, 6), Integer(0));
  EXPECT_EQ(binomial_int64(5, -1), 0);
  EXPECT_EQ(binomial_int64(5, 6), 0);
  EXPECT_THROW(binomial(-1, 0), InternalError);
  EXPECT_THROW(binomial_int64(kMaxBinomialRow + 1, 1), InternalError);
}

TEST(Binomial, TheTableEndsWhereSixtyThreeBitsDo) {
  EXPECT_EQ(Integer(binomial_int64(kMaxBinomialRow, kMaxBinomialRow / 2)),
            binomial(kMaxBinomialRow, kMaxBinomialRow / 2));
  EXPECT_GT(binomial(kMaxBinomialRow + 1, kMaxBinomialRow / 2), power_of_two(63));
}

TEST(Binomial, InTheRingsIsExactOrNearest) {
  for (const int n : {0, 1, 5, 52, 60, 66, 67, 126})
    for (int k = 0; k <= n; ++k) {
      const Rational exact(binomial(n, k));
      EXPECT_EQ(binomial_in<Rational>(n, k), exact);
      EXPECT_EQ(binomial_in<double>(n, k), nearest_double(exact)) << n << " over " << k;
      EXPECT_EQ(inverse_binomial_in<Rational>(n, k) * exact, Rational(1));
      EXPECT_LE(abs(Rational::from_double(inverse_binomial_in<double>(n, k)) * exact - Rational(1)),
                Rational::power_of_two(-52));
    }
}

TEST(Binomial, ProductWeightsOfOneCoefficientSumToOne) {
  for (const int p : {0, 1, 3, 33, 63})
    for (const int q : {0, 2, 33, 63})
      for (int k = 0; k <= p + q; ++k) {
        Rational sum;
        for (int i = std::max(0, k - q); i <= std::min(p, k); ++i) {
          const Rational weight = product_weight<Rational>(p, i, q, k - i);
          sum += weight;
          EXPECT_LE(abs(Rational::from_double(product_weight<double>(p, i, q, k - i)) - weight),
                    weight * Rational(3) * Rational::power_of_two(-53));
        }
        EXPECT_EQ(sum, Rational(1)) << p << " " << q << " " << k;
      }
}

}  // namespace
}  // namespace veritope
