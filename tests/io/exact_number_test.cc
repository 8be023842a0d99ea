// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/exact_number.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"

namespace veritope {
namespace {

std::string read(std::string_view token, ReadLimits limits = {}) {
  Rational value;
  switch (read_exact_number(token, limits, value)) {
    case DecimalFault::kNone: return value.to_string();
    case DecimalFault::kSyntax: return "syntax";
    case DecimalFault::kNotFinite: return "not finite";
    case DecimalFault::kDigits: return "digits";
    case DecimalFault::kExponent: return "exponent";
  }
  return "?";
}

TEST(ExactNumber, ADecimalIsTheNumberThatItSays) {
  EXPECT_EQ(read("0.1"), "1/10");
  EXPECT_EQ(read("-.5"), "-1/2");
  EXPECT_EQ(read("+5."), "5");
  EXPECT_EQ(read("1.25e2"), "125");
  EXPECT_EQ(read("1.25E-2"), "1/80");
  EXPECT_EQ(read("-0"), "0");
  EXPECT_EQ(read("0e99999"), "exponent");
  EXPECT_EQ(read("000.500"), "1/2");
  EXPECT_EQ(read("1e70"), "1" + std::string(70, '0'));
}

TEST(ExactNumber, FractionsAndHexadecimalFloatsAreExactToo) {
  EXPECT_EQ(read("2/6"), "1/3");
  EXPECT_EQ(read("-4/2"), "-2");
  EXPECT_EQ(read("0x1.8p-3"), "3/16");
  EXPECT_EQ(read("-0xA"), "-10");
  EXPECT_EQ(read("0x.1p0"), "1/16");
}

TEST(ExactNumber, WhatIsNoNumberIsRefused) {
  for (const char* bad : {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "1,5", "1/2/3", "1/-2", "1.5/2",
                          "0x", "0xp3", "0x1p", "1d3", "--1", "0x1.8q3"})
    EXPECT_EQ(read(bad), "syntax") << bad;
  for (const char* bad : {"nan", "-inf", "Infinity", "1.#QNAN", "NaN", "1/0"})
    EXPECT_EQ(read(bad), "not finite") << bad;
  ReadLimits limits;
  limits.max_digits = 4;
  limits.max_exponent = 9;
  EXPECT_EQ(read("1234.5", limits), "digits");
  EXPECT_EQ(read("1234567890123", limits), "1234567890123");
  EXPECT_EQ(read("12345678901234", limits), "digits");
  EXPECT_EQ(read("1234", limits), "1234");
  EXPECT_EQ(read("1/12345678901234", limits), "digits");
  EXPECT_EQ(read("1/12345", limits), "1/12345");
  EXPECT_EQ(read("0x12345", limits), "digits");
  EXPECT_EQ(read("1e10", limits), "exponent");
  EXPECT_EQ(read("1e9", limits), "1000000000");
  EXPECT_EQ(read("1e99999999999999999999999", limits), "exponent");
}

TEST(ExactNumber, OnlyFractionsOfTwosAndFivesAreDecimals) {
  EXPECT_EQ(exact_decimal(Rational(Integer(1), Integer(8))), "0.125");
  EXPECT_EQ(exact_decimal(Rational(Integer(-7), Integer(5))), "-1.4");
  EXPECT_EQ(exact_decimal(Rational(100)), "100");
  EXPECT_EQ(exact_decimal(Rational()), "0");
  EXPECT_EQ(exact_decimal(Rational(Integer(1), Integer(3))), std::nullopt);
  EXPECT_EQ(exact_decimal(Rational(Integer(1), Integer(14))), std::nullopt);
}

TEST(ExactNumber, AnExactDecimalReadsBackAsTheSameNumber) {
  Random random(20250701);
  for (int i = 0; i < 2000; ++i) {
    const auto mantissa = static_cast<std::int64_t>(random.next() >> (random.next() % 60));
    const auto exponent = static_cast<std::int64_t>(random.next() % 200) - 100;
    Rational value(mantissa);
    const Rational base(random.next() % 2 == 0 ? 2 : 10);
    for (std::int64_t k = 0; k < std::abs(exponent); ++k)
      exponent < 0 ? value /= base : value *= base;
    if (random.next() % 2 == 0) value.negate();
    const auto text = exact_decimal(value);
    ASSERT_TRUE(text) << "seed 20250701: " << value.to_string();
    Rational back;
    ASSERT_EQ(read_exact_decimal(*text, {}, back), DecimalFault::kNone) << *text;
    EXPECT_EQ(back, value) << *text;
  }
}

}  // namespace
}  // namespace veritope
