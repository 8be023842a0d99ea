// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/decimal_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "report/text_style.h"

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

using Ends = std::array<std::string, 2>;

TEST(RangeEnds, DifferWhereTheNumbersDo) {
  EXPECT_EQ(range_ends(1.5, 1.75), (Ends{"1.5", "1.75"}));
  EXPECT_EQ(range_ends(3.8, 3.8000000000002, 4), (Ends{"3.8", "3.8000000000002"}));
  EXPECT_EQ(range_ends(1.0, std::nextafter(1.0, 2.0)), (Ends{"1", "1.0000000000000002"}));
  EXPECT_EQ(range_ends(-1e-300, -0.99999999e-300, 2), (Ends{"-1e-300", "-9.9999999e-301"}));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(range_ends(-kInfinity, kInfinity), (Ends{"-inf", "inf"}));
  EXPECT_EQ(range_ends(quotient(1, 3), quotient(1, 3) + quotient(1, 1'000'000'000), 6),
            (Ends{"0.333333333", "0.333333334"}));
}

TEST(RangeEnds, AreEqualWhereTheNumbersAre) {
  EXPECT_EQ(range_ends(1.0 / 3, 1.0 / 3), (Ends{"0.333333", "0.333333"}));
  EXPECT_EQ(range_ends(-0.0, 0.0), (Ends{"0", "0"}));
  EXPECT_EQ(range_text(Interval(2.5)), "2.5");
  EXPECT_EQ(range_text(Interval::from_bounds(3.0, 3.0000000001)), "3 to 3.0000000001");
}

TEST(RangeEnds, OfBoxesDifferInEachCoordinate) {
  EXPECT_EQ(box_text({{0, 3.8, 1}, {1, 3.80000000001, 1}}),
            unbroken("(0, 3.8, 1)") + " to " + unbroken("(1, 3.80000000001, 1)"));
}

}  // namespace
}  // namespace veritope::report
