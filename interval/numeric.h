// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/numeric.h: numbers that describe an interval, and its construction from two numbers. Results are exact or
// rounded as said, in any floating-point environment. Source: [IEEE1788] 4.5.6, 9.2, 10.5.9.
#pragma once
#include "interval/interval.h"
#include "interval/signal.h"

namespace veritope {

/// The greatest lower bound: -0 for 0, +infinity for the empty set.
double inf(const Interval& a);
/// The least upper bound: +0 for 0, -infinity for the empty set.
double sup(const Interval& a);
/// The number nearest to the middle, ties to even; the largest finite number, with its sign, for a
/// half line; 0 for the whole line; NaN if empty. A member of every nonempty interval.
double mid(const Interval& a);
/// The least number r such that [m - r, m + r] contains a, m = mid(a); NaN if empty.
double rad(const Interval& a);
struct MidRad {
  double mid, rad;
};
MidRad mid_rad(const Interval& a);
/// hi - lo, rounded upward; NaN if empty.
double wid(const Interval& a);
/// max |x| and min |x| of the members; NaN if empty.
double mag(const Interval& a);
double mig(const Interval& a);

/// [lo, hi], or empty with kUndefinedOperation when that is not an interval (NaN, lo > hi, lo =
/// +infinity, hi = -infinity).
Signalled<Interval> nums_to_interval(double lo, double hi);

/// The tightest z such that b + z contains a, if a is bounded and at least as wide as b (so that
/// one exists); entire where it does not exist; empty for a empty and b bounded.
Interval cancel_minus(const Interval& a, const Interval& b);
/// cancel_minus(a, -b).
Interval cancel_plus(const Interval& a, const Interval& b);

}  // namespace veritope
