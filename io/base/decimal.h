// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/decimal.h: decimal numbers to the nearest binary64, ties to even; always correctly rounded.
// Theory: the two-word product of [Lem21] "Number parsing at a gigabyte per second", here with an interval
// around the truncated product: it answers only if both ends round alike, else big integers do (decimal_exact.cc).
#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

#include "io/base/read_limits.h"
#include "io/base/scan.h"

namespace veritope {

/// Why a token is not a number that the reading rule (and the limits) admit.
enum class DecimalFault { kNone, kSyntax, kNotFinite, kDigits, kExponent };

namespace internal {

/// 10^q = (high 2^64 + low + r) * 2^exponent with 0 <= r < 1; r = 0 for 0 <= q <= 55.
struct PowerOfTen {
  std::uint64_t high, low;
  int exponent;
};
inline constexpr int kMinPower = -330, kMaxPower = 310;
/// Element q - kMinPower; computed once, in less than a millisecond.
const PowerOfTen* powers_of_ten();

inline constexpr double kExactPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// digits * 10^exponent rounded to nearest even, infinity on overflow. `digits` are ASCII digits, any number.
/// @cost quadratic in the number of digits
double round_decimal_exactly(std::string_view digits, std::int64_t exponent);

}  // namespace internal

/// Grammar `[+-]? ( digits [ . digits? ] | . digits ) ( [eE] [+-]? digits )?`. -0 becomes +0.
class DecimalReader {
 public:
  explicit DecimalReader(const ReadLimits& limits);

  /// Reads the usual numbers: moves p past the number and returns true; or leaves p and returns false (then call
  /// read_slowly). A true answer is correctly rounded and within the limits; the next character is not examined.
  bool read_fast(const char*& p, double& value) const;

  /// Reads any number: `token` is the whole token.
  DecimalFault read_slowly(std::string_view token, double& value) const;

  /// w * 10^q rounded, if the two-word product decides the rounding; otherwise nothing. REQUIRES w
  /// > 0.
  std::optional<double> scale(std::uint64_t w, int q) const;

 private:
  /// Tries again without the zeros at the end of w: 0.50000000000000000 is exact.
  std::optional<double> scale_without_zeros(std::uint64_t w, int q) const;

  /// digits * 10^exponent rounded, infinity on overflow.
  double round(std::string_view digits, std::int64_t exponent) const;

  const internal::PowerOfTen* powers_;
  std::uint32_t max_digits_;
  std::uint32_t max_exponent_;
};

inline std::optional<double> DecimalReader::scale(std::uint64_t w, int q) const {
  using internal::kExactPowers;
  // [Cli90]: both factors are exact, so one rounding.
  if (w <= (std::uint64_t{1} << 53) && q >= -22 && q <= 22) {
    const auto exact = static_cast<double>(w);
    return q < 0 ? exact / kExactPowers[-q] : exact * kExactPowers[q];
  }
  if (q < internal::kMinPower || q > internal::kMaxPower) return std::nullopt;
  const internal::PowerOfTen& power = powers_[q - internal::kMinPower];
  const int shift = std::countl_zero(w);
  __extension__ using Word2 = unsigned __int128;
  const Word2 factor = w << shift;
  // Units of 2^64: the true product lies in [product, product + 2): the cut tail of low * w is below 1,
  // so is r * w. The sum cannot overflow: (2^64 - 1)(2^128 - 1) < 2^192.
  const Word2 product = factor * power.high + (factor * power.low >> 64);
  const auto high = static_cast<std::uint64_t>(product >> 64);
  const auto low = static_cast<std::uint64_t>(product);
  const int top = static_cast<int>(high >> 63);
  const std::uint64_t mask = (std::uint64_t{1} << (9 + top)) - 1;
  const std::uint64_t kept = high >> (9 + top);  // 53 bits and the rounding bit
  if ((high & mask) == mask && low >= UINT64_MAX - 1) return std::nullopt;  // may carry into `kept`
  if ((high & mask) == 0 && low == 0 && (kept & 1) != 0) return std::nullopt;  // may be a tie
  // value = kept * 2^(scale - 1), rounded to a multiple of 2^scale.
  const int scale = 128 + 9 + top + power.exponent - shift + 1;
  if (scale < -1074 || scale > 970) return std::nullopt;  // subnormal, or near overflow
  const std::uint64_t mantissa = (kept >> 1) + (kept & 1);
  // The leading bit adds one to the exponent field; so does a carry into bit 53.
  return std::bit_cast<double>((static_cast<std::uint64_t>(scale + 1074) << 52) + mantissa);
}

inline bool DecimalReader::read_fast(const char*& cursor, double& value) const {
  const char* p = cursor;
  const bool negative = *p == '-';
  p += (*p == '-' || *p == '+') ? 1 : 0;
  const char* const first = p;
  std::uint64_t w = 0;  // wraps with more than 19 digits; then the answer is false
  for (; is_digit(*p); ++p) w = w * 10 + static_cast<std::uint64_t>(*p - '0');
  auto num_digits = static_cast<std::uint64_t>(p - first);
  int q = 0;
  if (*p == '.') {
    const char* const fraction = ++p;
    for (std::uint64_t word = load8(p); non_digits(word) == 0; word = load8(p)) {
      w = w * 100000000 + eight_digits(word);
      p += 8;
    }
    for (; is_digit(*p); ++p) w = w * 10 + static_cast<std::uint64_t>(*p - '0');
    const auto length = static_cast<std::uint64_t>(p - fraction);
    num_digits += length;
    q = length < 64 ? -static_cast<int>(length) : -64;
  }
  if (num_digits == 0 || num_digits > 64 || num_digits > max_digits_) return false;
  if (num_digits > 19) {
    // Zeros in front do not fill w.
    for (const char* z = first; *z == '0' || *z == '.'; ++z) num_digits -= *z == '0' ? 1 : 0;
    if (num_digits > 19) return false;
  }
  if (*p == 'e' || *p == 'E') {
    const char* e = p + 1;
    const ScannedInteger exponent = scan_integer(e);
    if (!exponent.is_valid || exponent.magnitude > 400 || exponent.magnitude > max_exponent_) {
      return false;
    }
    q += exponent.is_negative ? -static_cast<int>(exponent.magnitude)
                              : static_cast<int>(exponent.magnitude);
    p = e;
  }
  if (w == 0) {
    value = 0;
  } else {
    std::optional<double> size = scale(w, q);
    if (!size) size = scale_without_zeros(w, q);
    if (!size) return false;
    value = negative ? -*size : *size;
  }
  cursor = p;
  return true;
}

}  // namespace veritope
