// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/decimal.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>

namespace veritope {
namespace {

// The parts of a token that matches the grammar.
struct DecimalParts {
  bool is_negative = false;
  std::string digits;         // the mantissa's, leading zeros included
  std::int64_t point = 0;     // the value is 0.digits * 10^point * 10^exponent
  std::int64_t exponent = 0;  // saturated at kFar
};

constexpr std::int64_t kFar = std::int64_t{1} << 50;

const char* take_digits(const char* p, const char* end, std::string& digits) {
  const char* last = p;
  while (last < end && is_digit(*last)) ++last;
  digits.append(p, last);
  return last;
}

std::optional<std::int64_t> take_exponent(const char* p, const char* end) {
  const bool negative = p < end && *p == '-';
  if (p < end && (*p == '-' || *p == '+')) ++p;
  std::string digits;
  if (take_digits(p, end, digits) != end || digits.empty()) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : digits) value = std::min(kFar, value * 10 + (c - '0'));
  return negative ? -value : value;
}

std::optional<DecimalParts> split(std::string_view token) {
  const char* p = token.data();
  const char* const end = p + token.size();
  DecimalParts parts;
  parts.is_negative = p < end && *p == '-';
  if (p < end && (*p == '-' || *p == '+')) ++p;
  p = take_digits(p, end, parts.digits);
  parts.point = static_cast<std::int64_t>(parts.digits.size());
  if (p < end && *p == '.') p = take_digits(p + 1, end, parts.digits);
  if (parts.digits.empty()) return std::nullopt;
  if (p == end) return parts;
  if (*p != 'e' && *p != 'E') return std::nullopt;
  const std::optional<std::int64_t> exponent = take_exponent(p + 1, end);
  if (!exponent) return std::nullopt;
  parts.exponent = *exponent;
  return parts;
}

}  // namespace

DecimalReader::DecimalReader(const ReadLimits& limits)
    : powers_(internal::powers_of_ten()),
      max_digits_(limits.max_digits),
      max_exponent_(limits.max_exponent) {}

std::optional<double> DecimalReader::scale_without_zeros(std::uint64_t w, int q) const {
  if (w % 10 != 0) return std::nullopt;
  for (; w % 10 == 0; w /= 10) ++q;
  return scale(w, q);
}

double DecimalReader::round(std::string_view digits, std::int64_t exponent) const {
  const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size());
  std::uint64_t w = 0;
  std::size_t used = zeros;
  for (; used < digits.size() && used < zeros + 19; ++used) {
    w = w * 10 + static_cast<std::uint64_t>(digits[used] - '0');
  }
  // The value lies in [w, w + 1] * 10^q. Rounding is monotonic: if both ends round alike, so does the value.
  const std::int64_t q = exponent + static_cast<std::int64_t>(digits.size() - used);
  if (w > 0 && std::abs(q) <= 400) {
    const std::optional<double> low = scale(w, static_cast<int>(q));
    const std::optional<double> high =
        used == digits.size() ? low : scale(w + 1, static_cast<int>(q));
    if (low && high && *low == *high) return *low;
  }
  return internal::round_decimal_exactly(digits, exponent);
}

DecimalFault DecimalReader::read_slowly(std::string_view token, double& value) const {
  const std::optional<DecimalParts> parts = split(token);
  if (!parts) return DecimalFault::kSyntax;
  if (parts->digits.size() > max_digits_) return DecimalFault::kDigits;
  if (std::abs(parts->exponent) > max_exponent_) return DecimalFault::kExponent;
  const std::int64_t exponent =
      parts->exponent + parts->point - static_cast<std::int64_t>(parts->digits.size());
  const double size = round(parts->digits, exponent);
  if (size > std::numeric_limits<double>::max()) return DecimalFault::kNotFinite;
  value = size == 0 ? 0 : (parts->is_negative ? -size : size);
  return DecimalFault::kNone;
}

}  // namespace veritope
