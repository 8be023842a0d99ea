// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/integer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "robust/base/check.h"

namespace veritope {
namespace {

TEST(Integer, HoldsEveryBuiltInInteger) {
  EXPECT_EQ(Integer().to_string(), "0");
  EXPECT_EQ(Integer(-7).to_string(), "-7");
  EXPECT_EQ(Integer(std::numeric_limits<std::int64_t>::min()).to_string(), "-9223372036854775808");
  EXPECT_EQ(Integer(std::numeric_limits<std::uint64_t>::max()).to_string(), "18446744073709551615");
  EXPECT_EQ(Integer(static_cast<unsigned char>(200)).to_string(), "200");
}

TEST(Integer, DoesNotConvertFromOrToDouble) {
  EXPECT_FALSE((std::is_constructible_v<Integer, double>));
  EXPECT_FALSE((std::is_constructible_v<Integer, bool>));
  EXPECT_FALSE((std::is_convertible_v<Integer, double>));
}

TEST(Integer, ComputesBeyondOneLimb) {
  const Integer a = Integer::from_decimal("123456789012345678901234567890");
  EXPECT_EQ((a * a).to_string(), "15241578753238836750495351562536198787501905199875019052100");
  EXPECT_EQ((a - a).to_string(), "0");
  EXPECT_EQ((-a + a), Integer(0));
  Integer b(5);
  b.add_product(a, Integer(2)).subtract_product(a, Integer(3));
  EXPECT_EQ(b, Integer(5) - a);
}

TEST(Integer, ShiftsExactlyToTheLeftAndToTheFloorOnTheRight) {
  Integer a(-5);
  EXPECT_EQ(a.shift_left(100).to_string(), "-6338253001141147007483516026880");
  EXPECT_EQ(a.shift_right(101), Integer(-3));  // floor(-2.5)
  EXPECT_EQ(power_of_two(70).to_string(), "1180591620717411303424");
}

TEST(Integer, ComparesAndTellsItsSign) {
  EXPECT_LT(Integer(-3), Integer(2));
  EXPECT_EQ(Integer(0).sign(), Sign::kZero);
  EXPECT_EQ(sign_of(Integer(-1)), Sign::kNegative);
  EXPECT_TRUE(Integer(0).is_zero());
  EXPECT_FALSE(power_of_two(200).is_zero());
}

TEST(Integer, TellsItsBits) {
  EXPECT_EQ(Integer(0).bit_length(), 0u);
  EXPECT_EQ(Integer(-8).bit_length(), 4u);
  EXPECT_EQ(Integer(-8).trailing_zeros(), 3u);
  EXPECT_EQ(power_of_two(200).trailing_zeros(), 200u);
  EXPECT_TRUE(power_of_two(200).test_bit(200));
  EXPECT_FALSE(power_of_two(200).test_bit(199));
  EXPECT_FALSE(power_of_two(200).test_bit(1000));
  EXPECT_EQ(Integer(-9).low_bits(), 9u);
  EXPECT_THROW(Integer(0).trailing_zeros(), InternalError);
}

TEST(Integer, ConvertsBackIfItFits) {
  EXPECT_EQ(Integer(-12).to_int64(), -12);
  EXPECT_FALSE(power_of_two(63).fits_int64());
  EXPECT_TRUE((-power_of_two(63)).fits_int64());
  EXPECT_THROW(power_of_two(63).to_int64(), InternalError);
}

TEST(Integer, ReadsLimbsAndDecimals) {
  const std::uint64_t limbs[] = {1, 2};
  EXPECT_EQ(Integer::from_limbs(limbs, 2, true), -(power_of_two(65) + Integer(1)));
  EXPECT_EQ(Integer::from_decimal("-42"), Integer(-42));
  for (const std::string& text : {std::string(), std::string("-"), std::string("4x2"), std::string("+42"),
                                  std::string("1234567890 1234567890"), std::string(20, ' ') + "1",
                                  std::string("12345678901234567890\0a", 22)})
    EXPECT_THROW(Integer::from_decimal(text), InternalError) << text;
}

TEST(Integer, DividesAsNamed) {
  EXPECT_EQ(floor_divide(Integer(-7), Integer(2)), Integer(-4));
  EXPECT_EQ(divide_exactly(Integer(-42), Integer(7)), Integer(-6));
  EXPECT_EQ(gcd(Integer(-12), Integer(18)), Integer(6));
  EXPECT_EQ(gcd(Integer(0), Integer(0)), Integer(0));
  EXPECT_EQ(abs(Integer(-3)), Integer(3));
  EXPECT_THROW(floor_divide(Integer(1), Integer(0)), InternalError);
  EXPECT_THROW(divide_exactly(Integer(1), Integer(0)), InternalError);
}

TEST(Integer, PowersAndShiftsMultiply) {
  EXPECT_EQ(power(Integer(10), 0), Integer(1));
  EXPECT_EQ(power(Integer(0), 0), Integer(1));
  EXPECT_EQ(power(Integer(-10), 21).to_string(), "-1000000000000000000000");
  EXPECT_EQ(Integer(-5) << 70, Integer(-5) * power_of_two(70));
  EXPECT_EQ(Integer(0) << 70, Integer(0));
}

TEST(Integer, FloorSqrtIsTheGreatestIntegerWhoseSquareIsAtMostTheNumber) {
  EXPECT_EQ(floor_sqrt(Integer(0)), Integer(0));
  for (const Integer& root : {Integer(1), Integer(2), Integer(46340), power(Integer(10), 40)}) {
    EXPECT_EQ(floor_sqrt(root * root), root);
    EXPECT_EQ(floor_sqrt(root * root - Integer(1)), root - Integer(1));
    EXPECT_EQ(floor_sqrt(root * root + root + root), root);
  }
  EXPECT_THROW(floor_sqrt(Integer(-1)), InternalError);
}

TEST(Integer, CopiesAreIndependentAndMovesKeepTheValue) {
  Integer a = power_of_two(300);
  Integer b = a;
  b += Integer(1);
  EXPECT_NE(a, b);
  Integer c = std::move(b);
  EXPECT_EQ(c, a + Integer(1));
  b = c;
  EXPECT_EQ(b, c);
  b = std::move(c);
  EXPECT_EQ(b, a + Integer(1));
}

}  // namespace
}  // namespace veritope
