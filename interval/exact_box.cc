// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/exact_box.h"

#include "robust/base/check.h"

namespace veritope {
namespace {

Integer floor_of(const Rational& x) { return floor_divide(x.numerator(), x.denominator()); }

Rational floor_to(const Rational& x, std::int64_t bits) {
  return Rational(floor_of(x * Rational::power_of_two(bits))) * Rational::power_of_two(-bits);
}

// The simplest fraction between 0 < lo and hi >= lo, by the continued fraction that the ends share.
Rational simplest_positive(Rational lo, Rational hi) {
  std::vector<Integer> quotients;
  for (;;) {
    const Integer whole = floor_of(lo);
    if (Rational(whole) == lo) {
      quotients.push_back(whole);
      break;
    }
    if (Rational(whole + Integer(1)) <= hi) {
      quotients.push_back(whole + Integer(1));
      break;
    }
    quotients.push_back(whole);
    Rational next_lo = Rational(1) / (hi - Rational(whole));
    hi = Rational(1) / (lo - Rational(whole));
    lo = std::move(next_lo);
  }
  Rational out(quotients.back());
  for (std::size_t i = quotients.size() - 1; i-- > 0;)
    out = Rational(quotients[i]) + Rational(1) / out;
  return out;
}

}  // namespace

std::int64_t floor_log2(const Rational& x) {
  VT_CHECK(x.sign() != Sign::kZero, "the logarithm of 0");
  const auto e = static_cast<std::int64_t>(x.numerator().bit_length()) -
                 static_cast<std::int64_t>(x.denominator().bit_length());
  return Rational::power_of_two(e) <= abs(x) ? e : e - 1;
}

ExactInterval rounded_outward(const ExactInterval& a, std::int64_t bits) {
  return {floor_to(a.lo, bits), -floor_to(-a.hi, bits)};
}

Rational simplest_member(const ExactInterval& a) {
  if (a.contains(Rational(0))) return Rational(0);
  if (a.lo.sign() == Sign::kPositive) return simplest_positive(a.lo, a.hi);
  return -simplest_positive(-a.hi, -a.lo);
}

}  // namespace veritope
