// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/exact_number.h"

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

TEST(ExactNumber, WhatIsWrittenIsReadWithinTheSameLimits) {
  // The shortest digits of 1.5e-4096 are 15e-4097, over the limit of the exponent: the point moves.
  for (const char* token :
       {"1.5e-4096", "-123e4096", "0.00125e-4096", "1e4096", "7e-4096", "12300e4096"}) {
    Rational value, back;
    ASSERT_EQ(read_exact_decimal(token, {}, value), DecimalFault::kNone);
    const auto text = exact_decimal(value);
    ASSERT_TRUE(text) << token;
    ASSERT_EQ(read_exact_decimal(*text, {}, back), DecimalFault::kNone) << *text;
    EXPECT_EQ(back, value) << *text;
  }
  EXPECT_EQ(spell_decimal("15", -4097, {}), "1.5e-4096");
  EXPECT_EQ(spell_decimal("15", 4098, {}), "1500e+4096");
  EXPECT_EQ(spell_decimal("15", -5096, {}), std::nullopt);
  EXPECT_EQ(spell_decimal("1", -5095, {}), "0." + std::string(998, '0') + "1e-4096");
  EXPECT_EQ(exact_decimal(Rational::power_of_two(-1000)).has_value(), true);
  EXPECT_EQ(exact_decimal(Rational::power_of_two(-4000)), std::nullopt);  // 2796 digits
}

TEST(ExactNumber, SmallLimitsOfDigitsAndExponentsAreKept) {
  Random random(20251121);
  for (int i = 0; i < 4000; ++i) {
    ReadLimits limits;
    limits.max_digits = static_cast<std::uint32_t>(1 + random.next() % 12);
    limits.max_exponent = static_cast<std::uint32_t>(random.next() % 12);
    std::string token;
    for (std::uint64_t n = 1 + random.next() % limits.max_digits; n > 0; --n)
      token += static_cast<char>('0' + random.next() % 10);
    if (random.next() % 2 == 0) token.insert(random.next() % token.size() + 1, ".");
    token += (random.next() % 2 == 0 ? "e-" : "e") +
             std::to_string(random.next() % (limits.max_exponent + std::uint64_t{1}));
    Rational value, back;
    ASSERT_EQ(read_exact_decimal(token, limits, value), DecimalFault::kNone) << token;
    const auto text = exact_decimal(value, limits);
    ASSERT_TRUE(text) << "seed 20251121, case " << i << ": " << token;
    ASSERT_EQ(read_exact_decimal(*text, limits, back), DecimalFault::kNone)
        << token << " " << *text;
    EXPECT_EQ(back, value) << token << " " << *text;
  }
}

}  // namespace
}  // namespace veritope
