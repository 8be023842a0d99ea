// SPDX-License-Identifier: LGPL-3.0-or-later
#include "named_predicates/number_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "io/base/source.h"
#include "robust/binary64.h"

namespace veritope {
namespace {

ReadLimits no_limits() {
  ReadLimits limits;
  limits.max_digits = std::numeric_limits<std::uint32_t>::max();
  limits.max_exponent = std::numeric_limits<std::uint32_t>::max();
  return limits;
}

std::string_view without_sign(std::string_view token) {
  if (token.starts_with('-') || token.starts_with('+')) token.remove_prefix(1);
  return token;
}

Error not_a_number(std::string_view token) {
  const std::string_view word = without_sign(token);
  if (is_word(word, "nan") || is_word(word, "inf") || is_word(word, "infinity")) {
    return Error{Code::kNotFinite, {}, quoted(token) + " is not finite"};
  }
  return Error{Code::kSyntax, {}, "a number expected, but there is " + quoted(token)};
}

Error too_large(std::string_view token) {
  return Error{Code::kNotFinite, {}, quoted(token) + " is beyond the largest binary64 number"};
}

bool is_hexadecimal(std::string_view token) {
  const std::string_view number = without_sign(token);
  return number.size() > 1 && number[0] == '0' && (number[1] == 'x' || number[1] == 'X');
}

// The digit's value, 0 to 15, or -1.
int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

// mantissa * 2^exponent, plus a positive number below 2^exponent if has_rest.
struct HexNumber {
  std::uint64_t mantissa = 0;
  std::int64_t exponent = 0;
  bool has_rest = false;
};

// Removes hexadecimal digits from the front of `text` and appends them to the number. `shift` is added to the exponent
// for each digit.
std::size_t take_hex_digits(std::string_view& text, std::int64_t shift, HexNumber& number) {
  std::size_t count = 0;
  for (; count < text.size() && hex_digit(text[count]) >= 0; ++count) {
    const auto digit = static_cast<std::uint64_t>(hex_digit(text[count]));
    number.exponent += shift;
    if (number.mantissa >> 60 == 0) {
      number.mantissa = number.mantissa << 4 | digit;
    } else {
      number.exponent += 4;
      number.has_rest = number.has_rest || digit != 0;
    }
  }
  text.remove_prefix(count);
  return count;
}

// Reads `p [+-]? digits`, or nothing, up to the end of `text`; false if something else is there.
bool take_binary_exponent(std::string_view text, HexNumber& number) {
  constexpr std::int64_t kFar = std::int64_t{1}
                                << 50;  // too large for any number of digits to compensate
  if (text.empty()) return true;
  if (text[0] != 'p' && text[0] != 'P') return false;
  text.remove_prefix(1);
  const bool is_negative = text.starts_with('-');
  text = without_sign(text);
  std::int64_t exponent = 0;
  for (const char c : text) {
    if (!is_digit(c)) return false;
    exponent = std::min(kFar, exponent * 10 + (c - '0'));
  }
  number.exponent += is_negative ? -exponent : exponent;
  return !text.empty();
}

Result<double> rounded_to_itself(const HexNumber& number, std::string_view token) {
  if (number.mantissa == 0) return 0.0;
  const int zeros = std::countr_zero(number.mantissa);
  const std::uint64_t odd = number.mantissa >> zeros;
  const std::int64_t exponent = number.exponent + zeros;
  const auto width = static_cast<int>(std::bit_width(odd));
  if (exponent + width > 1024) return too_large(token);
  if (number.has_rest || width > 53 || exponent < kMinExponent) {
    return Error{Code::kLossy, {}, quoted(token) + " has more bits than a binary64 number holds"};
  }
  const double size = std::ldexp(static_cast<double>(odd), static_cast<int>(exponent));
  return token.starts_with('-') ? -size : size;
}

Result<double> read_hexadecimal(std::string_view token) {
  std::string_view text = without_sign(token).substr(2);
  HexNumber number;
  std::size_t num_digits = take_hex_digits(text, 0, number);
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    num_digits += take_hex_digits(text, -4, number);
  }
  if (num_digits == 0 || !take_binary_exponent(text, number)) return not_a_number(token);
  return rounded_to_itself(number, token);
}

}  // namespace

NumberReader::NumberReader() : decimals_(no_limits()) {}

Result<double> NumberReader::read(std::string_view token) const {
  if (is_hexadecimal(token)) return read_hexadecimal(token);
  double value = 0;
  const char* p = token.data();
  if (decimals_.read_fast(p, value) && p == token.data() + token.size()) return value;
  switch (decimals_.read_slowly(token, value)) {
    case DecimalFault::kNone: return value;
    case DecimalFault::kNotFinite: return too_large(token);
    case DecimalFault::kDigits:
    case DecimalFault::kExponent:
      return Error{Code::kOverLimit, {}, "the exponent of " + quoted(token) + " is out of range"};
    case DecimalFault::kSyntax: break;
  }
  return not_a_number(token);
}

}  // namespace veritope
