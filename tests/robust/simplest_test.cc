// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/simplest.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"

namespace veritope {
namespace {

Rational ratio(std::int64_t n, std::int64_t d) { return Rational(n) / Rational(d); }

TEST(SimplestFraction, IsTheKnownOne) {
  EXPECT_EQ(simplest_between(Rational(0), Rational(1)), ratio(1, 2));
  EXPECT_EQ(simplest_between(Rational(0), Rational(2)), Rational(1));
  EXPECT_EQ(simplest_between(Rational(1), Rational(2)), ratio(3, 2));
  EXPECT_EQ(simplest_between(ratio(1, 3), ratio(1, 2)), ratio(2, 5));
  EXPECT_EQ(simplest_between(ratio(33, 100), ratio(34, 100)), ratio(1, 3));
  EXPECT_EQ(simplest_between(ratio(314, 100), ratio(315, 100)), ratio(22, 7));
  EXPECT_EQ(simplest_between(ratio(7, 2), ratio(19, 2)), Rational(4));
}

// Law: no fraction between has a smaller denominator, and the numbers of its own denominator before it are not between.
TEST(SimplestFraction, HasTheLeastDenominator) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const std::int64_t d = random.between(1, 200), e = random.between(1, 200);
    const Rational a = ratio(random.between(0, 300), d), b = ratio(random.between(0, 300), e);
    if (a == b) continue;
    const auto [lo, hi] = std::minmax(a, b);
    const Rational found = simplest_between(lo, hi);
    SCOPED_TRACE(testing::Message() << "between " << lo.to_string() << " and " << hi.to_string());
    EXPECT_TRUE(lo < found && found < hi);
    const auto denominator = static_cast<std::int64_t>(found.denominator().low_bits());
    for (std::int64_t n = 1; n <= denominator; ++n) {
      const Integer below =
          floor_divide((lo * Rational(n)).numerator(), (lo * Rational(n)).denominator());
      const Rational next = Rational(below + Integer(1)) / Rational(n);
      if (n < denominator)
        EXPECT_FALSE(next < hi) << n;
      else
        EXPECT_EQ(next, found);
    }
  }
}

}  // namespace
}  // namespace veritope
