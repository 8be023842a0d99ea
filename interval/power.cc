// SPDX-License-Identifier: LGPL-3.0-or-later
// Powers, roots, and the functions of two intervals: from their values at corners.
#include <algorithm>
#include <cmath>

#include "interval/evaluate_internal.h"
#include "interval/functions.h"
#include "interval/infinity_internal.h"
#include "interval/mpfr_internal.h"
#include "interval/relations.h"

namespace veritope::internal {

namespace {

// x^n and the n-th root. The sign of a zero tells from which side a pole is approached.
double power(double x, std::int64_t n, mpfr_rnd_t direction) {
  Real v(x);
  mpfr_pow_si(v.get(), v.get(), n, direction);
  return v.round(direction);
}
double root(double x, std::int64_t n, mpfr_rnd_t direction) {
  Real v(x);
  mpfr_rootn_si(v.get(), v.get(), n, direction);
  const double r = v.round(direction);
  // MPFR 4.2.0 returns exactly 1 for a root whose degree exceeds approximately 2^61. Such a root is within 2^-50 of
  // 1, unless x is 0 or infinite.
  constexpr std::int64_t kTrusted = std::int64_t{1} << 53;
  if ((n > -kTrusted && n < kTrusted) || (r != 1 && r != -1) || x == r) return r;
  return direction == MPFR_RNDD ? std::nextafter(r, -kInfinity) : std::nextafter(r, kInfinity);
}

Evaluated pown_negative(const Interval& x, std::int64_t n) {
  if (x.sign() == Sign3::kZero) return no_value();
  const Decoration local = is_member(0, x) ? Decoration::kTrv : Decoration::kCom;
  if (n % 2 == 0) {
    const Interval a = abs(x);
    return {Interval::from_bounds(power(a.hi(), n, MPFR_RNDD),
                                  power(larger(0.0, a.lo()), n, MPFR_RNDU)),
            local};
  }
  if (order_key(x.lo()) < 0 && order_key(x.hi()) > 0) return {Interval::entire(), Decoration::kTrv};
  const double lo = order_key(x.lo()) == 0 ? 0.0 : x.lo(),
               hi = order_key(x.hi()) == 0 ? -0.0 : x.hi();
  return {Interval::from_bounds(power(hi, n, MPFR_RNDD), power(lo, n, MPFR_RNDU)), local};
}

// The least and the largest of f at the four corners, rounded outward.
Interval hull_of_corners(RealFunction2 f, const Interval& a, const Interval& b) {
  double lo = kInfinity, hi = -kInfinity;
  for (double x : {a.lo(), a.hi()})
    for (double y : {b.lo(), b.hi()}) {
      lo = std::min(lo, rounded(f, x, y, MPFR_RNDD));
      hi = std::max(hi, rounded(f, x, y, MPFR_RNDU));
    }
  return Interval::from_bounds(lo, hi);
}

}  // namespace

Evaluated eval_pown(const Interval& x, std::int64_t n) {
  if (x.is_empty()) return no_value();
  if (n == 0) return {Interval(1.0), Decoration::kCom};
  const internal::MpfrScope environment;
  if (n < 0) return pown_negative(x, n);
  const Interval in = n % 2 == 0 ? abs(x) : x;
  return {Interval::from_bounds(power(in.lo(), n, MPFR_RNDD), power(in.hi(), n, MPFR_RNDU)),
          Decoration::kCom};
}

Evaluated eval_rootn(const Interval& x, std::int64_t n) {
  if (n == 0) return no_value();
  const bool even = n % 2 == 0;
  const Interval in = even ? intersection(x, Interval::from_bounds(0, kInfinity)) : x;
  if (in.is_empty() || (n < 0 && in.sign() == Sign3::kZero)) return no_value();
  const internal::MpfrScope environment;
  const bool pole = n < 0 && is_member(0, in), defined = is_subset(x, in) && !pole;
  if (pole && order_key(in.lo()) < 0 && order_key(in.hi()) > 0)
    return {Interval::entire(), Decoration::kTrv};
  // Signed zeros as in pown_negative.
  const double lo = order_key(in.lo()) == 0 ? 0.0 : in.lo();
  const double hi = order_key(in.hi()) == 0 ? (n < 0 ? -0.0 : 0.0) : in.hi();
  const Decoration local = defined ? Decoration::kCom : Decoration::kTrv;
  if (n > 0) return {Interval::from_bounds(root(lo, n, MPFR_RNDD), root(hi, n, MPFR_RNDU)), local};
  return {Interval::from_bounds(root(hi, n, MPFR_RNDD), root(lo, n, MPFR_RNDU)), local};
}

// exp(b log a) on a > 0, with the limits at a = 0 and infinity; 0^b = 0 for b > 0. The exponent is bilinear in (log
// a, b), so that its extremes lie at corners; 0 * infinity is 0 there, as in MPFR's powers.
Evaluated eval_pow(const Interval& a, const Interval& b) {
  const Interval base = intersection(a, Interval::from_bounds(0, kInfinity));
  if (base.is_empty() || b.is_empty()) return no_value();
  if (base.sign() == Sign3::kZero) {
    if (order_key(b.hi()) <= 0) return no_value();
    const bool defined = is_singleton(a) && order_key(b.lo()) > 0;
    return {Interval(), defined ? Decoration::kCom : Decoration::kTrv};
  }
  const internal::MpfrScope environment;
  const Interval positive = Interval::from_bounds(larger(0.0, base.lo()), base.hi());
  const bool defined = order_key(a.lo()) > 0 || (order_key(a.lo()) == 0 && order_key(b.lo()) > 0);
  return {
      hull_of_corners(
          mpfr_pow,
          order_key(positive.lo()) == 0 ? Interval::from_bounds(0.0, positive.hi()) : positive, b),
      defined ? Decoration::kCom : Decoration::kTrv};
}

Evaluated eval_hypot(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return no_value();
  const internal::MpfrScope environment;
  const Interval x = abs(a), y = abs(b);
  return {Interval::from_bounds(rounded(mpfr_hypot, x.lo(), y.lo(), MPFR_RNDD),
                                rounded(mpfr_hypot, x.hi(), y.hi(), MPFR_RNDU)),
          Decoration::kCom};
}

namespace {

// The angles of the points (x, y), y >= 0, without the origin. REQUIRES y.lo() >= 0.
Interval angles_of_upper_half(const Interval& y, const Interval& x) {
  const double yl = larger(0.0, y.lo()), yh = larger(0.0, y.hi());
  const bool on_axis = order_key(yh) == 0;
  const bool right = order_key(x.hi()) > 0, left = order_key(x.lo()) < 0;
  // The angle falls as x grows; as y grows it rises on the right and falls on the left.
  const auto angle = [](double v, double u, mpfr_rnd_t direction) {
    return rounded(mpfr_atan2, v, order_key(u) == 0 ? 0.0 : u, direction);
  };
  const double lo =
      right ? angle(yl, x.hi(), MPFR_RNDD) : angle(yh, on_axis ? x.lo() : x.hi(), MPFR_RNDD);
  const double hi = left ? angle(yl, x.lo(), MPFR_RNDU) : angle(yh, x.lo(), MPFR_RNDU);
  return Interval::from_bounds(lo, hi);
}

}  // namespace

Evaluated eval_atan2(const Interval& y, const Interval& x) {
  if (y.is_empty() || x.is_empty()) return no_value();
  if (y.sign() == Sign3::kZero && x.sign() == Sign3::kZero) return no_value();
  const internal::MpfrScope environment;
  const Decoration at_origin =
      is_member(0, y) && is_member(0, x) ? Decoration::kTrv : Decoration::kCom;
  const bool left = order_key(x.lo()) < 0;
  if (order_key(y.lo()) >= 0) {
    // On the cut itself the angle is pi: the limit from above, but not from below.
    const bool touches_cut = left && order_key(y.lo()) == 0;
    return {angles_of_upper_half(y, x),
            weakest(at_origin, touches_cut ? Decoration::kDac : Decoration::kCom)};
  }
  if (order_key(y.hi()) < 0 || (order_key(y.hi()) == 0 && !left))
    return {-angles_of_upper_half(-y, x), at_origin};
  if (left) {
    const double pi_up = rounded(mpfr_atan2, 0.0, -1, MPFR_RNDU);
    return {Interval::from_bounds(-pi_up, pi_up), weakest(at_origin, Decoration::kDef)};
  }
  const Interval above = Interval::from_bounds(0, y.hi()),
                 below = Interval::from_bounds(0, -y.lo());
  return {hull(angles_of_upper_half(above, x), -angles_of_upper_half(below, x)), at_origin};
}

}  // namespace veritope::internal

namespace veritope {

Interval fma(const Interval& a, const Interval& b, const Interval& c) {
  if (a.is_empty() || b.is_empty() || c.is_empty()) return Interval::empty();
  const internal::MpfrScope environment;
  internal::Real least(mpfr_prec_t{106}), most(mpfr_prec_t{106}), product(mpfr_prec_t{106});
  bool some = false;
  for (double x : {a.lo(), a.hi()})
    for (double y : {b.lo(), b.hi()}) {
      const internal::Real u(x), v(y);
      mpfr_mul(product.get(), u.get(), v.get(), MPFR_RNDN);  // exact
      if (mpfr_nan_p(product.get())) mpfr_set_zero(product.get(), 1);
      if (!some || mpfr_less_p(product.get(), least.get()))
        mpfr_set(least.get(), product.get(), MPFR_RNDN);
      if (!some || mpfr_greater_p(product.get(), most.get()))
        mpfr_set(most.get(), product.get(), MPFR_RNDN);
      some = true;
    }
  internal::Real lo, hi;
  mpfr_add(lo.get(), least.get(), internal::Real(c.lo()).get(), MPFR_RNDD);
  mpfr_add(hi.get(), most.get(), internal::Real(c.hi()).get(), MPFR_RNDU);
  return Interval::from_bounds(lo.round(MPFR_RNDD), hi.round(MPFR_RNDU));
}

}  // namespace veritope
