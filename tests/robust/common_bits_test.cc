// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/common_bits.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace veritope {
namespace {

// The most bits of the integers and of the denominator.
std::uint64_t by_definition(const std::vector<Rational>& numbers) {
  Integer common(1);
  for (const Rational& x : numbers) common = lcm(common, x.denominator());
  std::uint64_t out = common.bit_length();
  for (const Rational& x : numbers)
    out = std::max(out, (x.numerator() * divide_exactly(common, x.denominator())).bit_length());
  return out;
}

TEST(CommonBits, BoundsTheBitsOfTheIntegersFromAboveWithinAFactorOfTwo) {
  std::mt19937_64 random(20);
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<Rational> numbers;
    CommonBits bits(1 << 20);
    for (std::uint64_t n = random() % 8; n-- > 0;) {
      const std::uint64_t top = random() >> random() % 64, bottom = random() >> random() % 64;
      numbers.push_back(Rational(Integer(static_cast<std::int64_t>(top >> 1))) /
                        Rational(Integer(static_cast<std::int64_t>(bottom >> 1) + 1)));
      bits.add(numbers.back());
    }
    EXPECT_GE(bits.bits(), by_definition(numbers)) << "trial " << trial;
    EXPECT_LE(bits.bits(), 2 * by_definition(numbers)) << "trial " << trial;
    EXPECT_FALSE(bits.is_beyond());
  }
}

TEST(CommonBits, SaysWhetherTheBoundIsBeyondTheLimit) {
  CommonBits at(64), beyond(64), denominator(64);
  at.add(Rational::power_of_two(63));
  EXPECT_FALSE(at.is_beyond());
  beyond.add(Rational::power_of_two(64));
  EXPECT_TRUE(beyond.is_beyond());
  denominator.add(Rational::power_of_two(-64));
  EXPECT_TRUE(denominator.is_beyond());
  denominator.add(Rational(1));  // it stays so
  EXPECT_TRUE(denominator.is_beyond());
}

}  // namespace
}  // namespace veritope
