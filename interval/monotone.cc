// SPDX-License-Identifier: LGPL-3.0-or-later
// Functions that rise or fall on their domain, or on both sides of 0.

#include "interval/evaluate_internal.h"
#include "interval/infinity_internal.h"
#include "interval/mpfr_internal.h"
#include "interval/relations.h"

namespace veritope::internal {

namespace {

enum class Slope { kRising, kFalling };
enum class Ends { kIn, kOut };  // do finite ends of the domain belong to it?

struct Shape {
  RealFunction f;
  Slope slope = Slope::kRising;
  double lo = -kInfinity, hi = kInfinity;
  Ends ends = Ends::kIn;
};

Evaluated monotone(const Shape& shape, const Interval& x) {
  const Interval domain = Interval::from_bounds(shape.lo, shape.hi);
  const Interval in = intersection(x, domain);
  if (in.is_empty()) return no_value();
  const bool out = shape.ends == Ends::kOut;
  if (out && is_singleton(in) && !is_interior(in, domain)) return no_value();
  const bool defined = is_subset(x, domain) && (!out || is_interior(x, domain));
  const MpfrScope environment;
  return {shape.slope == Slope::kRising ? rising(shape.f, in.lo(), in.hi())
                                        : falling(shape.f, in.lo(), in.hi()),
          defined ? Decoration::kCom : Decoration::kTrv};
}

// A function that falls on both sides of a pole at 0, without a value there.
Evaluated falling_around_pole(RealFunction f, const Interval& x) {
  if (x.is_empty() || x.sign() == Sign3::kZero) return no_value();
  const std::int64_t lo = order_key(x.lo()), hi = order_key(x.hi());
  if (lo < 0 && hi > 0) return {Interval::entire(), Decoration::kTrv};
  const MpfrScope environment;
  // The sign of a zero end tells from which side the pole is approached.
  return {falling(f, lo == 0 ? 0.0 : x.lo(), hi == 0 ? -0.0 : x.hi()),
          lo == 0 || hi == 0 ? Decoration::kTrv : Decoration::kCom};
}

// acoth(x) = atanh(1 / x) for |x| >= 1, with as many bits as the rounding needs: acoth(x) is not a binary64 number,
// so that some precision decides.
int acoth_rounded(mpfr_ptr out, mpfr_srcptr x, mpfr_rnd_t direction) {
  if (mpfr_inf_p(x)) return mpfr_ui_div(out, 1, x, direction);
  for (mpfr_prec_t precision = 128;; precision *= 2) {
    Real low(precision), high(precision);
    mpfr_ui_div(low.get(), 1, x, MPFR_RNDD);
    mpfr_ui_div(high.get(), 1, x, MPFR_RNDU);
    mpfr_atanh(low.get(), low.get(), MPFR_RNDD);
    mpfr_atanh(high.get(), high.get(), MPFR_RNDU);
    mpfr_prec_round(low.get(), mpfr_get_prec(out), direction);
    mpfr_prec_round(high.get(), mpfr_get_prec(out), direction);
    if (mpfr_equal_p(low.get(), high.get())) return mpfr_set(out, low.get(), direction);
  }
}

// acot with range (0, pi): the angle of the point (x, 1).
int acot_rounded(mpfr_ptr out, mpfr_srcptr x, mpfr_rnd_t direction) {
  const Real one(1.0);
  return mpfr_atan2(out, one.get(), x, direction);
}

}  // namespace

Evaluated eval_exp(const Interval& x) { return monotone({mpfr_exp}, x); }
Evaluated eval_exp2(const Interval& x) { return monotone({mpfr_exp2}, x); }
Evaluated eval_exp10(const Interval& x) { return monotone({mpfr_exp10}, x); }
Evaluated eval_expm1(const Interval& x) { return monotone({mpfr_expm1}, x); }
Evaluated eval_log(const Interval& x) {
  return monotone({mpfr_log, Slope::kRising, 0, kInfinity, Ends::kOut}, x);
}
Evaluated eval_log2(const Interval& x) {
  return monotone({mpfr_log2, Slope::kRising, 0, kInfinity, Ends::kOut}, x);
}
Evaluated eval_log10(const Interval& x) {
  return monotone({mpfr_log10, Slope::kRising, 0, kInfinity, Ends::kOut}, x);
}
Evaluated eval_logp1(const Interval& x) {
  return monotone({mpfr_log1p, Slope::kRising, -1, kInfinity, Ends::kOut}, x);
}
Evaluated eval_asin(const Interval& x) { return monotone({mpfr_asin, Slope::kRising, -1, 1}, x); }
Evaluated eval_acos(const Interval& x) { return monotone({mpfr_acos, Slope::kFalling, -1, 1}, x); }
Evaluated eval_atan(const Interval& x) { return monotone({mpfr_atan}, x); }
Evaluated eval_acot(const Interval& x) { return monotone({acot_rounded, Slope::kFalling}, x); }
Evaluated eval_sinh(const Interval& x) { return monotone({mpfr_sinh}, x); }
Evaluated eval_tanh(const Interval& x) { return monotone({mpfr_tanh}, x); }
Evaluated eval_asinh(const Interval& x) { return monotone({mpfr_asinh}, x); }
Evaluated eval_acosh(const Interval& x) {
  return monotone({mpfr_acosh, Slope::kRising, 1, kInfinity}, x);
}
Evaluated eval_atanh(const Interval& x) {
  return monotone({mpfr_atanh, Slope::kRising, -1, 1, Ends::kOut}, x);
}
Evaluated eval_cbrt(const Interval& x) { return monotone({mpfr_cbrt}, x); }

// Even functions are evaluated at |x|.
Evaluated eval_cosh(const Interval& x) { return monotone({mpfr_cosh}, abs(x)); }
Evaluated eval_sech(const Interval& x) { return monotone({mpfr_sech, Slope::kFalling}, abs(x)); }

Evaluated eval_coth(const Interval& x) { return falling_around_pole(mpfr_coth, x); }
Evaluated eval_csch(const Interval& x) { return falling_around_pole(mpfr_csch, x); }

Evaluated eval_acoth(const Interval& x) {
  const Shape right{acoth_rounded, Slope::kFalling, 1, kInfinity, Ends::kOut};
  const Evaluated above = monotone(right, x), below = monotone(right, -x);
  return {hull(above.value, -below.value),
          above.local == Decoration::kTrv ? below.local : above.local};
}

}  // namespace veritope::internal
