// SPDX-License-Identifier: LGPL-3.0-or-later
// The reverse of sin, cos and tan: the first and the last point of `in` whose value lies in c.
#include <algorithm>
#include <cmath>

#include "interval/mpfr_internal.h"
#include "interval/relations.h"
#include "interval/reverse.h"

namespace veritope {

namespace {

using internal::Real;
using internal::RealFunction;

// Sets `out` to the least of the points base + k period, k an integer, that is not below `from`. `out` is too small
// by at most 2^-250 of the larger of the point and the period, and it is exact if the point is 0. A point that lies
// below `from` by no more than that counts as not below it: the result is still an enclosure, and not wider by
// anything that binary64 shows.
void least_not_below(Real& out, const Real& base, const Real& period, const Real& from) {
  const mpfr_prec_t precision = mpfr_get_prec(out.get());
  Real k(precision), margin(precision);
  mpfr_sub(k.get(), from.get(), base.get(), MPFR_RNDD);
  mpfr_div(k.get(), k.get(), period.get(), MPFR_RNDD);
  mpfr_abs(margin.get(), k.get(), MPFR_RNDU);
  mpfr_add_ui(margin.get(), margin.get(), 1, MPFR_RNDU);
  mpfr_mul_2si(margin.get(), margin.get(), -260 - std::max<long>(0, mpfr_get_exp(margin.get())),
               MPFR_RNDU);
  mpfr_sub(k.get(), k.get(), margin.get(), MPFR_RNDD);
  mpfr_rint_ceil(k.get(), k.get(), MPFR_RNDD);
  mpfr_mul(out.get(), k.get(), period.get(), MPFR_RNDD);
  mpfr_add(out.get(), out.get(), base.get(), MPFR_RNDD);
  if (mpfr_zero_p(k.get()) && mpfr_zero_p(base.get())) return;
  mpfr_abs(margin.get(), out.get(), MPFR_RNDU);
  mpfr_mul_2si(margin.get(), margin.get(), -260, MPFR_RNDU);
  mpfr_sub(out.get(), out.get(), margin.get(), MPFR_RNDD);
}

struct Wave {
  RealFunction f, inverse;
  unsigned long half_turns;  // in a period
  // Where else, besides inverse(v), does f have the value v within a period?
  enum class Second { kNone, kOpposite, kSupplement } second;
};
constexpr Wave kSin{mpfr_sin, mpfr_asin, 2, Wave::Second::kSupplement};
constexpr Wave kCos{mpfr_cos, mpfr_acos, 2, Wave::Second::kOpposite};
constexpr Wave kTan{mpfr_tan, mpfr_atan, 1, Wave::Second::kNone};

// The best lower bound, as a binary64 number, on the t >= from with f(t) in c. REQUIRES that c meets the range of f
// and that `from` is finite.
double first_point(const Wave& w, const Interval& c, double from) {
  const double below = internal::rounded(w.f, from, MPFR_RNDD),
               above = internal::rounded(w.f, from, MPFR_RNDU);
  if (below >= c.lo() && above <= c.hi()) return from;
  // The value to look for is the end of c on the side of f(from). tan starts again from below.
  const double v = w.second == Wave::Second::kNone || below < c.lo() ? c.lo() : c.hi();
  const auto precision =
      static_cast<mpfr_prec_t>(400 + (from == 0 ? 0 : std::max(0, std::ilogb(from))));
  Real base(precision), period(precision), pi(precision), out(precision), other(precision);
  const Real value(v), start(from);
  mpfr_const_pi(pi.get(), MPFR_RNDN);
  mpfr_mul_ui(period.get(), pi.get(), w.half_turns, MPFR_RNDN);
  w.inverse(base.get(), value.get(), MPFR_RNDN);
  least_not_below(out, base, period, start);
  if (w.second != Wave::Second::kNone) {
    if (w.second == Wave::Second::kOpposite) {
      mpfr_neg(base.get(), base.get(), MPFR_RNDN);
    } else {
      mpfr_sub(base.get(), pi.get(), base.get(), MPFR_RNDN);
    }
    least_not_below(other, base, period, start);
    mpfr_min(out.get(), out.get(), other.get(), MPFR_RNDN);
  }
  return std::max(from, out.round(MPFR_RNDD));
}

// `mirrored`: the values that f has at -t are in it iff those at t are in c.
Interval reversed(const Wave& w, const Interval& c, const Interval& mirrored, const Interval& in) {
  if (c.is_empty() || in.is_empty()) return Interval::empty();
  const internal::MpfrScope environment;
  const double lo = internal::is_infinite(in.lo()) ? in.lo() : first_point(w, c, in.lo());
  const double hi = internal::is_infinite(in.hi()) ? in.hi() : -first_point(w, mirrored, -in.hi());
  return lo <= hi && lo <= in.hi() && hi >= in.lo() ? Interval::from_bounds(lo, hi)
                                                    : Interval::empty();
}

}  // namespace

Interval sin_rev(const Interval& c, const Interval& in) {
  const Interval values = intersection(c, Interval::from_bounds(-1, 1));
  return reversed(kSin, values, -values, in);
}
Interval cos_rev(const Interval& c, const Interval& in) {
  const Interval values = intersection(c, Interval::from_bounds(-1, 1));
  return reversed(kCos, values, values, in);
}
Interval tan_rev(const Interval& c, const Interval& in) { return reversed(kTan, c, -c, in); }

}  // namespace veritope
