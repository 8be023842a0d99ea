// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/scan.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "io/base/decimal.h"

namespace veritope {
namespace {

std::string padded(const std::string& text) { return text + std::string(64, '\n'); }

TEST(Digits, EveryByteThatIsNoDigitStopsTheRunAtItsPlace) {
  for (int c = 0; c < 256; ++c) {
    for (std::size_t at = 0; at < 9; ++at) {
      std::string text = "123456789";
      text[at] = static_cast<char>(c);
      const bool is_a_digit = c >= '0' && c <= '9';
      EXPECT_EQ(is_digit(static_cast<char>(c)), is_a_digit);
      const std::string integer = padded(text);
      const char* p = integer.data();
      const ScannedInteger value = scan_integer(p);
      const std::size_t sign = at == 0 && (c == '-' || c == '+') ? 9 : at;
      EXPECT_EQ(p - integer.data(), static_cast<long>(is_a_digit ? 9 : sign)) << c << " at " << at;
      EXPECT_EQ(value.is_valid, is_a_digit || sign > 0);
      if (c == 'e' || c == 'E' || is_a_digit) continue;
      // The fraction of a decimal, read eight digits at once.
      const std::string decimal = padded("0." + text);
      const DecimalReader reader((ReadLimits()));
      p = decimal.data();
      double number = 0;
      ASSERT_TRUE(reader.read_fast(p, number));
      EXPECT_EQ(p - decimal.data(), 2 + static_cast<long>(at)) << c << " at " << at;
    }
  }
}

TEST(ScannedInteger, MatchesTheGrammarAndSaturates) {
  const auto scan = [](const std::string& text) {
    const std::string all = padded(text);
    const char* p = all.data();
    const ScannedInteger value = scan_integer(p);
    EXPECT_TRUE(!value.is_valid || p == all.data() + text.size()) << text;
    return value;
  };
  EXPECT_EQ(scan("0").magnitude, 0u);
  EXPECT_EQ(scan("+1234567").magnitude, 1234567u);
  EXPECT_EQ(scan("12345678").magnitude, 12345678u);
  EXPECT_EQ(scan("-123456789012").magnitude, 123456789012u);
  EXPECT_TRUE(scan("-123456789012").is_negative);
  EXPECT_EQ(scan("18446744073709551615").magnitude, UINT64_MAX);
  EXPECT_EQ(scan("18446744073709551616").magnitude, UINT64_MAX);
  EXPECT_EQ(scan("99999999999999999999999999").magnitude, UINT64_MAX);
  EXPECT_EQ(scan("000000000000000000000000000042").magnitude, 42u);
  EXPECT_EQ(scan("000000000000000000000000000042").num_digits, 30u);
  EXPECT_EQ(scan("-7").num_digits, 1u);
  for (const char* text : {"", "-", "+", "x", "--1", "+-1", " 1"})
    EXPECT_FALSE(scan(text).is_valid) << text;
  EXPECT_TRUE(scan("-0").is_below(1));
  EXPECT_FALSE(scan("-1").is_below(UINT64_MAX));
  EXPECT_FALSE(scan("5").is_below(5));
}

TEST(ScannedInteger, AgreesWithToStringOnRandomNumbers) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const std::uint64_t value = random() >> (random() % 64);
    const std::string text = padded(std::to_string(value));
    const char* p = text.data();
    ASSERT_EQ(scan_integer(p).magnitude, value);
  }
}

TEST(CharClass, BlanksLineEndsAndNothingElse) {
  for (int c = 0; c < 256; ++c) {
    const char byte = static_cast<char>(c);
    EXPECT_EQ(is_blank(byte), c == ' ' || c == '\t' || c == '\v' || c == '\f');
    EXPECT_EQ(is_eol(byte), c == '\n' || c == '\r');
    EXPECT_EQ(has_class(byte, kTokenEndOrComment), is_blank(byte) || is_eol(byte) || c == '#');
  }
}

TEST(IsWord, ComparesAsciiLettersInAnyCase) {
  EXPECT_TRUE(is_word("SoLiD", "solid"));
  EXPECT_FALSE(is_word("solid ", "solid"));
  EXPECT_FALSE(is_word("soli", "solid"));
  EXPECT_FALSE(is_word("SOLID\xC4", "solid"));
}

}  // namespace
}  // namespace veritope
