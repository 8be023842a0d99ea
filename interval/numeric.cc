// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/numeric.h"

#include <cmath>
#include <limits>

#include "interval/infinity_internal.h"
#include "interval/relations.h"
#include "robust/base/fp_guard.h"

namespace veritope {

namespace {

using internal::kInfinity;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<double>::max();

// The number nearest to (lo + hi) / 2. Sums below 2^-1021 are exact and are halved with one rounding; the others are
// halved exactly; if the sum overflows, the halves of the ends lose no bit.
double middle(double lo, double hi) {
  const double sum = lo + hi;
  const double m = internal::is_infinite(sum) ? lo / 2 + hi / 2 : sum / 2;
  return m == 0 ? 0 : m;
}

double up_difference(double a, double b) {
  const ScopedUpward upward;
  return fenced(fenced(a) - fenced(b));
}

}  // namespace

double inf(const Interval& a) {
  if (a.is_empty()) return kInfinity;
  return internal::order_key(a.lo()) == 0 ? -0.0 : a.lo();
}

double sup(const Interval& a) {
  if (a.is_empty()) return -kInfinity;
  return internal::order_key(a.hi()) == 0 ? 0.0 : a.hi();
}

double mid(const Interval& a) {
  if (a.is_empty()) return kNan;
  const bool no_lo = internal::is_infinite(a.lo()), no_hi = internal::is_infinite(a.hi());
  if (no_lo || no_hi) return no_lo && no_hi ? 0 : (no_lo ? -kLargest : kLargest);
  const ScopedDefaultFp nearest;
  return fenced(middle(fenced(a.lo()), fenced(a.hi())));
}

double rad(const Interval& a) { return mid_rad(a).rad; }

MidRad mid_rad(const Interval& a) {
  if (a.is_empty()) return {kNan, kNan};
  const double m = mid(a);
  return {m, internal::larger(up_difference(m, a.lo()), up_difference(a.hi(), m))};
}

double wid(const Interval& a) { return a.is_empty() ? kNan : up_difference(a.hi(), a.lo()); }

double mag(const Interval& a) { return a.is_empty() ? kNan : sup(abs(a)); }

double mig(const Interval& a) { return a.is_empty() ? kNan : std::fabs(abs(a).lo()); }

Signalled<Interval> nums_to_interval(double lo, double hi) {
  if (internal::is_nan(lo) || internal::is_nan(hi) || internal::less(hi, lo) ||
      (internal::is_infinite(lo) && internal::order_key(lo) == internal::order_key(hi)))
    return {Interval::empty(), Signal::kUndefinedOperation};
  return {Interval::from_bounds(lo, hi)};
}

Interval cancel_minus(const Interval& a, const Interval& b) {
  if (a.is_empty() && (b.is_empty() || is_common(b))) return Interval::empty();
  if (!is_common(a) || !is_common(b)) return Interval::entire();
  const auto exact = [](double v) { return Rational::from_double(v); };
  {
    // Widths are compared exactly only if their roundings do not decide.
    const double wide = wid(a), narrow = -up_difference(a.lo(), a.hi());
    const double other = wid(b), other_narrow = -up_difference(b.lo(), b.hi());
    if (internal::less(wide, other_narrow)) return Interval::entire();
    if (internal::less(narrow, other) &&
        exact(a.hi()) - exact(a.lo()) < exact(b.hi()) - exact(b.lo()))
      return Interval::entire();
  }
  return Interval::from_bounds(internal::negated(up_difference(b.lo(), a.lo())),
                               up_difference(a.hi(), b.hi()));
}

Interval cancel_plus(const Interval& a, const Interval& b) { return cancel_minus(a, -b); }

}  // namespace veritope
