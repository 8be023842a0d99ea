// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/simplest.h"

namespace veritope {

Rational simplest_between(const Rational& lo, const Rational& hi) {
  if (lo == hi) return lo;
  const Rational floor(floor_divide(lo.numerator(), lo.denominator()));
  if (floor + Rational(1) < hi) return floor + Rational(1);
  const Rational from = lo - floor, to = hi - floor;  // 0 <= from < to <= 1
  if (from.sign() == Sign::kZero) {
    const Rational inverse = Rational(1) / to;
    return floor + Rational(1) / Rational(floor_divide(inverse.numerator(), inverse.denominator()) +
                                          Integer(1));
  }
  return floor + Rational(1) / simplest_between(Rational(1) / to, Rational(1) / from);
}

}  // namespace veritope
