// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/ring_numbers.h: Interval as a ring of the algebra of splines/: all results are enclosures.
#pragma once
#include "interval/numeric.h"
#include "splines/ring.h"

namespace veritope {

/// Knots are exact; a parameter may be an interval. REQUIRES a live ScopedUpward.
template <>
struct RingNumbers<Interval> {
  using Knot = Rational;
  static Interval ratio(std::int64_t p, std::int64_t q) {
    if (q == 1 && p > -(std::int64_t{1} << 53) && p < std::int64_t{1} << 53)
      return Interval(static_cast<double>(p));
    return of_knot(Rational(p) / Rational(q));
  }
  static Interval fraction(const Interval& t, const Rational& a, const Rational& b) {
    return (t - of_knot(a)) / of_knot(b - a);
  }
  static Interval of_knot(const Rational& k) { return enclose(k); }
};

}  // namespace veritope
