// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/decimal_text.h"

#include <gtest/gtest.h>

namespace veritope::report {
namespace {

Rational quotient(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

TEST(ShortDecimal, IsExactWhereItSaysSo) {
  EXPECT_TRUE(is_short_decimal(Rational(0)));
  EXPECT_TRUE(is_short_decimal(quotient(-1, 8)));
  EXPECT_TRUE(is_short_decimal(quotient(123456, 1)));
  EXPECT_TRUE(is_short_decimal(quotient(123456, 1000000000)));
  EXPECT_TRUE(is_short_decimal(Rational(12) * Rational::power_of_two(0)));
}

TEST(ShortDecimal, IsNotExactWhereDigitsAreDropped) {
  EXPECT_FALSE(is_short_decimal(quotient(1, 3)));
  EXPECT_FALSE(is_short_decimal(quotient(1234567, 1)));
  EXPECT_TRUE(is_short_decimal(quotient(1234567, 1), 7));
  EXPECT_FALSE(is_short_decimal(Rational::power_of_two(-40)));
  EXPECT_FALSE(is_short_decimal(Rational(1) + Rational::power_of_two(-400)));
}

}  // namespace
}  // namespace veritope::report
