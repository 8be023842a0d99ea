// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/decimal_exact.cc: decimals in big integers: the table of powers of ten, and the rounding that is always
// right.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "io/base/decimal.h"
#include "robust/integer.h"

namespace veritope::internal {
namespace {

std::int64_t num_bits(const Integer& v) { return static_cast<std::int64_t>(v.bit_length()); }

// The leading 128 bits of 5^q (q >= 0) or of 2^k / 5^-q, cut off; 10^q = 5^q 2^q.
PowerOfTen power_of_ten(int q) {
  Integer bits = power(Integer(5), static_cast<std::uint64_t>(std::abs(q)));
  const auto length = static_cast<int>(num_bits(bits));
  PowerOfTen power{};
  if (q >= 0) {
    if (length <= 128) {
      bits.shift_left(static_cast<std::uint64_t>(128 - length));
    } else {
      bits.shift_right(static_cast<std::uint64_t>(length - 128));
    }
    power.exponent = length - 128 + q;
  } else {
    // 2^(length - 1) < 5^-q < 2^length, so the quotient has 128 bits.
    bits = floor_divide(power_of_two(static_cast<std::uint64_t>(127 + length)), bits);
    power.exponent = q - 127 - length;
  }
  power.low = bits.low_bits();
  power.high = bits.shift_right(64).low_bits();
  return power;
}

std::vector<PowerOfTen> make_powers() {
  std::vector<PowerOfTen> powers;
  for (int q = kMinPower; q <= kMaxPower; ++q) powers.push_back(power_of_ten(q));
  return powers;
}

// numerator / denominator > 0, rounded.
double round_quotient(Integer numerator, Integer denominator) {
  // The quotient lies in (2^(k-1), 2^(k+1)); keep at least 53 bits, or down to 2^-1074.
  const std::int64_t k = num_bits(numerator) - num_bits(denominator);
  std::int64_t ulp = std::max<std::int64_t>(k - 53, -1074);
  if (ulp > 0) denominator.shift_left(static_cast<std::uint64_t>(ulp));
  if (ulp < 0) numerator.shift_left(static_cast<std::uint64_t>(-ulp));
  Integer quotient = floor_divide(numerator, denominator);
  Integer rest = std::move(numerator.subtract_product(quotient, denominator));
  if (num_bits(quotient) > 53) {
    ++ulp;  // one bit more than fits
    if (quotient.test_bit(0)) rest += denominator;
    quotient.shift_right(1);
    denominator.shift_left(1);
  }
  const auto half = rest.shift_left(1) <=> denominator;
  if (half > 0 || (half == 0 && quotient.test_bit(0))) quotient += Integer(1);
  // At most 2^53, so the conversion is exact; ldexp is exact or overflows to infinity.
  return std::ldexp(static_cast<double>(quotient.to_int64()), static_cast<int>(ulp));
}

}  // namespace

const PowerOfTen* powers_of_ten() {
  static const std::vector<PowerOfTen> powers = make_powers();
  return powers.data();
}

double round_decimal_exactly(std::string_view digits, std::int64_t exponent) {
  const std::size_t first = digits.find_first_not_of('0');
  if (first == digits.npos) return 0;
  digits.remove_prefix(first);
  const std::size_t last = digits.find_last_not_of('0');
  exponent += static_cast<std::int64_t>(digits.size() - 1 - last);
  digits = digits.substr(0, last + 1);
  // 10^(magnitude - 1) <= value < 10^magnitude; 2^1024 < 10^309 and 2^-1075 > 10^-324.
  const std::int64_t magnitude = exponent + static_cast<std::int64_t>(digits.size());
  if (magnitude > 309) return std::numeric_limits<double>::infinity();
  if (magnitude < -323) return 0;
  Integer numerator = Integer::from_decimal(digits), denominator(1);
  (exponent >= 0 ? numerator : denominator) *=
      power(Integer(10), static_cast<std::uint64_t>(std::abs(exponent)));
  return round_quotient(std::move(numerator), std::move(denominator));
}

}  // namespace veritope::internal
