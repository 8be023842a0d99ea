// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/short_numbers_internal.h"

#include <cstdint>

namespace veritope::internal {

Rational multiple_below(const Rational& x, const Rational& unit) {
  const Rational ratio = x / unit;
  return Rational(floor_divide(ratio.numerator(), ratio.denominator())) * unit;
}

Rational multiple_above(const Rational& x, const Rational& unit) {
  return -multiple_below(-x, unit);
}

Rational power_of_two_below(const Rational& x) {
  // 2^(n - 1) <= numerator < 2^n, and so for the denominator.
  const auto exponent = static_cast<std::int64_t>(x.numerator().bit_length()) -
                        static_cast<std::int64_t>(x.denominator().bit_length());
  Rational power = Rational::power_of_two(exponent);
  return power <= x ? power : power / Rational(2);
}

Rational short_above(const Rational& x) {
  if (x.sign() == Sign::kZero) return x;
  return multiple_above(x, power_of_two_below(x) * Rational::power_of_two(-10));
}

}  // namespace veritope::internal
