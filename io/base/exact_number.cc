// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/exact_number.h"

#include <algorithm>
#include <array>
#include <utility>

namespace veritope {
namespace {

Integer power_of_ten(std::uint64_t n) {
  static const auto kSmall = [] {
    std::array<Integer, 64> table;
    table[0] = Integer(1);
    for (std::size_t i = 1; i < table.size(); ++i) table[i] = table[i - 1] * Integer(10);
    return table;
  }();
  if (n < kSmall.size()) return kSmall[n];
  return power(Integer(10), n);
}

bool names_no_finite_number(std::string_view token) {
  if (token.starts_with('-') || token.starts_with('+')) token.remove_prefix(1);
  using namespace std::string_view_literals;
  for (const std::string_view word : {"nan"sv, "inf"sv, "infinity"sv, "nan(ind)"sv, "-nan"sv})
    if (is_word(token, word)) return true;
  return token.starts_with("1.#") && token.size() > 3;
}

// The parts of a number: digits with a point somewhere, then an exponent after one of two letters.
struct NumberParts {
  bool is_negative = false;
  std::string digits;              // without the point, zeros in front included
  std::uint64_t num_fraction = 0;  // digits after the point
  bool exponent_is_negative = false;
  std::uint64_t exponent = 0;  // saturated at 2^40
};

template <typename IsDigit>
bool split(std::string_view token, char letter, IsDigit is_digit_here, NumberParts& parts) {
  std::size_t i = 0;
  bool has_point = false;
  for (; i < token.size(); ++i) {
    if (token[i] == '.') {
      if (std::exchange(has_point, true)) return false;
    } else if (is_digit_here(token[i])) {
      parts.digits += token[i];
      parts.num_fraction += has_point ? 1 : 0;
    } else {
      break;
    }
  }
  if (parts.digits.empty()) return false;
  if (i == token.size()) return true;
  if ((token[i] | 0x20) != letter) return false;
  ++i;
  if (i < token.size() && (token[i] == '-' || token[i] == '+'))
    parts.exponent_is_negative = token[i++] == '-';
  if (i == token.size()) return false;
  for (; i < token.size(); ++i) {
    if (!is_digit(token[i])) return false;
    parts.exponent = std::min(parts.exponent * 10 + static_cast<std::uint64_t>(token[i] - '0'),
                              std::uint64_t{1} << 40);
  }
  return true;
}

bool take_sign(std::string_view& token) {
  const bool is_negative = token.starts_with('-');
  if (is_negative || token.starts_with('+')) token.remove_prefix(1);
  return is_negative;
}

DecimalFault check_limits(const NumberParts& parts, const ReadLimits& limits) {
  if (parts.digits.size() > limits.max_digits) return DecimalFault::kDigits;
  return parts.exponent > limits.max_exponent ? DecimalFault::kExponent : DecimalFault::kNone;
}

DecimalFault read_hexadecimal(std::string_view token, bool is_negative, const ReadLimits& limits,
                              Rational& value) {
  NumberParts parts;
  const auto is_hex = [](char c) {
    return is_digit(c) || (static_cast<unsigned char>((c | 0x20) - 'a') < 6);
  };
  if (!split(token, 'p', is_hex, parts)) return DecimalFault::kSyntax;
  if (const DecimalFault fault = check_limits(parts, limits); fault != DecimalFault::kNone)
    return fault;
  Integer whole;
  for (const char c : parts.digits)
    whole = whole.shift_left(4) + Integer(is_digit(c) ? c - '0' : (c | 0x20) - 'a' + 10);
  const auto exponent = static_cast<std::int64_t>(parts.exponent);
  const std::int64_t shift = (parts.exponent_is_negative ? -exponent : exponent) -
                             4 * static_cast<std::int64_t>(parts.num_fraction);
  value = Rational(std::move(whole)) * Rational::power_of_two(shift);
  if (is_negative) value.negate();
  return DecimalFault::kNone;
}

bool is_all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

std::string plain(std::string digits, std::uint64_t num_fraction) {
  if (num_fraction == 0) return digits;
  if (digits.size() <= num_fraction) digits.insert(0, num_fraction + 1 - digits.size(), '0');
  digits.insert(digits.size() - num_fraction, 1, '.');
  return digits;
}

}  // namespace

DecimalFault read_exact_decimal(std::string_view token, const ReadLimits& limits, Rational& value) {
  if (names_no_finite_number(token)) return DecimalFault::kNotFinite;
  const bool is_negative = take_sign(token);
  NumberParts parts;
  if (!split(token, 'e', is_digit, parts)) return DecimalFault::kSyntax;
  if (const DecimalFault fault = check_limits(parts, limits); fault != DecimalFault::kNone)
    return fault;
  // Zeros at the end of a fraction change nothing and would cost a larger power.
  while (parts.num_fraction > 0 && parts.digits.back() == '0' && parts.digits.size() > 1) {
    parts.digits.pop_back();
    --parts.num_fraction;
  }
  Integer whole = Integer::from_decimal(parts.digits);
  const auto exponent = static_cast<std::int64_t>(parts.exponent);
  const std::int64_t power = (parts.exponent_is_negative ? -exponent : exponent) -
                             static_cast<std::int64_t>(parts.num_fraction);
  if (whole.is_zero()) {
    value = Rational();
  } else if (power >= 0) {
    value = Rational(whole * power_of_ten(static_cast<std::uint64_t>(power)));
  } else {
    value = Rational(std::move(whole), power_of_ten(static_cast<std::uint64_t>(-power)));
  }
  if (is_negative) value.negate();
  return DecimalFault::kNone;
}

DecimalFault read_exact_number(std::string_view token, const ReadLimits& limits, Rational& value) {
  std::string_view rest = token;
  const bool is_negative = take_sign(rest);
  if (rest.starts_with("0x") || rest.starts_with("0X"))
    return read_hexadecimal(rest.substr(2), is_negative, limits, value);
  // A decimal within the limits may have this many digits when it is written out.
  const std::uint64_t most = std::uint64_t{limits.max_digits} + limits.max_exponent;
  const std::size_t slash = rest.find('/');
  if (slash == rest.npos) {
    if (!is_all_digits(rest)) return read_exact_decimal(token, limits, value);
    if (rest.size() > most) return DecimalFault::kDigits;
    value = Rational(Integer::from_decimal(rest));
    if (is_negative) value.negate();
    return DecimalFault::kNone;
  }
  const std::string_view p = rest.substr(0, slash), q = rest.substr(slash + 1);
  if (!is_all_digits(p) || !is_all_digits(q)) return DecimalFault::kSyntax;
  if (p.size() > most || q.size() > most) return DecimalFault::kDigits;
  const Integer denominator = Integer::from_decimal(q);
  if (denominator.is_zero()) return DecimalFault::kNotFinite;
  value = Rational(Integer::from_decimal(p), denominator);
  if (is_negative) value.negate();
  return DecimalFault::kNone;
}

std::optional<std::string> spell_decimal(std::string digits, std::int64_t exponent,
                                         const ReadLimits& limits) {
  const auto most_digits = static_cast<std::int64_t>(limits.max_digits);
  const auto most_exponent = static_cast<std::int64_t>(limits.max_exponent);
  auto length = static_cast<std::int64_t>(digits.size());
  const std::int64_t plain_length =
      exponent >= 0 ? length + exponent : std::max(length, 1 - exponent);
  if (exponent <= 6 && -exponent <= length + 6 && plain_length <= most_digits) {
    if (exponent > 0) digits.append(static_cast<std::size_t>(exponent), '0');
    return plain(std::move(digits),
                 static_cast<std::uint64_t>(std::max(-exponent, std::int64_t{0})));
  }
  // The point moves until the exponent is within its limit.
  const std::int64_t written = std::clamp(exponent, -most_exponent, most_exponent);
  const std::int64_t moved = exponent - written;
  length = moved >= 0 ? length + moved : std::max(length, 1 - moved);
  if (length > most_digits) return std::nullopt;
  if (moved > 0) digits.append(static_cast<std::size_t>(moved), '0');
  if (moved < 0) digits = plain(std::move(digits), static_cast<std::uint64_t>(-moved));
  if (written == 0) return digits;
  return digits + (written > 0 ? "e+" : "e-") + std::to_string(std::abs(written));
}

std::optional<std::string> exact_decimal(const Rational& value, const ReadLimits& limits) {
  Integer rest = value.denominator();
  const std::uint64_t twos = remove_factor(&rest, 2), fives = remove_factor(&rest, 5);
  if (rest != Integer(1)) return std::nullopt;
  const std::uint64_t places = std::max(twos, fives);
  Integer scaled = abs(value.numerator());
  scaled.shift_left(places - twos);
  if (places > fives) scaled *= power(5, places - fives);
  std::string digits = scaled.to_string();
  // After a point the last digit is not 0: `places` is the least number.
  std::uint64_t zeros = 0;
  while (zeros + 1 < digits.size() && digits[digits.size() - 1 - zeros] == '0') ++zeros;
  digits.resize(digits.size() - zeros);
  auto text =
      spell_decimal(std::move(digits),
                    static_cast<std::int64_t>(zeros) - static_cast<std::int64_t>(places), limits);
  if (text && value.sign() == Sign::kNegative) text->insert(0, 1, '-');
  return text;
}

}  // namespace veritope
