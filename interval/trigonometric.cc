// SPDX-License-Identifier: LGPL-3.0-or-later
// Periodic functions: the quarter turns of the ends tell which turning points and poles lie between them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/evaluate_internal.h"
#include "interval/infinity_internal.h"
#include "interval/mpfr_internal.h"
#include "interval/relations.h"

namespace veritope::internal {

namespace {

// The quarters floor(x / (pi / 2)) of both ends: that of the lower end mod 4, and the other counted on from it.
struct Quarters {
  int lo, hi;  // lo in 0..3, hi >= lo counted on from there; at most lo + 8
};

// q = floor(x / (pi / 2)). Only 0 is a multiple of pi / 2, and no other binary64 number comes closer to one than
// 2^-62 of a quarter ([Mul16] 11.3): 80 bits after the binary point decide.
void quarter(mpfr_ptr q, double x) {
  const int exponent = x == 0 ? 0 : std::max(0, std::ilogb(x));
  Real quotient(static_cast<mpfr_prec_t>(exponent + 160)),
      pi(static_cast<mpfr_prec_t>(exponent + 160));
  const Real value(x);
  mpfr_const_pi(pi.get(), MPFR_RNDN);
  mpfr_mul_2ui(quotient.get(), value.get(), 1, MPFR_RNDN);
  mpfr_div(quotient.get(), quotient.get(), pi.get(), MPFR_RNDN);
  mpfr_rint_floor(q, quotient.get(), MPFR_RNDN);
}

// REQUIRES x bounded.
Quarters quarters(const Interval& x) {
  Real lo(static_cast<mpfr_prec_t>(1100)), hi(static_cast<mpfr_prec_t>(1100));
  quarter(lo.get(), x.lo());
  quarter(hi.get(), x.hi());
  mpfr_sub(hi.get(), hi.get(), lo.get(), MPFR_RNDN);
  const int between =
      mpfr_cmp_ui(hi.get(), 8) > 0 ? 8 : static_cast<int>(mpfr_get_si(hi.get(), MPFR_RNDN));
  const Real four(4.0);
  mpfr_fmod(lo.get(), lo.get(), four.get(), MPFR_RNDN);
  const int start = static_cast<int>(mpfr_get_si(lo.get(), MPFR_RNDN));
  const int from = start < 0 ? start + 4 : start;
  return {from, from + between};
}

// Is there a k with q.lo < 4 k + turn <= q.hi: does a quarter = turn (mod 4) start inside?
bool passes(const Quarters& q, int turn) {
  for (int k = turn; k <= q.hi; k += 4)
    if (k > q.lo) return true;
  return false;
}

// f oscillates between -1 and 1, its least and its greatest value, which it reaches at the starts of the quarters
// `bottom` and `top` (mod 4).
Evaluated wave(RealFunction f, const Interval& x, int top, int bottom) {
  if (x.is_empty()) return no_value();
  if (!is_common(x)) return {Interval::from_bounds(-1, 1), Decoration::kCom};
  const MpfrScope environment;
  const Quarters q = quarters(x);
  const double lo = passes(q, bottom)
                        ? -1
                        : std::min(rounded(f, x.lo(), MPFR_RNDD), rounded(f, x.hi(), MPFR_RNDD));
  const double hi =
      passes(q, top) ? 1 : std::max(rounded(f, x.lo(), MPFR_RNDU), rounded(f, x.hi(), MPFR_RNDU));
  return {Interval::from_bounds(lo, hi), Decoration::kCom};
}

}  // namespace

Evaluated eval_sin(const Interval& x) { return wave(mpfr_sin, x, 1, 3); }

Evaluated eval_cos(const Interval& x) { return wave(mpfr_cos, x, 0, 2); }

Evaluated eval_tan(const Interval& x) {
  if (x.is_empty()) return no_value();
  if (!is_common(x)) return {Interval::entire(), Decoration::kTrv};
  const MpfrScope environment;
  const Quarters q = quarters(x);
  if (passes(q, 1) || passes(q, 3)) return {Interval::entire(), Decoration::kTrv};
  return {rising(mpfr_tan, x.lo(), x.hi()), Decoration::kCom};
}

Evaluated eval_cot(const Interval& x) {
  if (x.is_empty() || x.sign() == Sign3::kZero) return no_value();
  if (!is_common(x)) return {Interval::entire(), Decoration::kTrv};
  const MpfrScope environment;
  // An end can be the pole 0. If the upper end is, it starts a quarter that x does not enter.
  const bool ends_at_pole = order_key(x.hi()) == 0, starts_at_pole = order_key(x.lo()) == 0;
  Quarters q = quarters(x);
  if (ends_at_pole) --q.hi;
  if (passes(q, 0) || passes(q, 2)) return {Interval::entire(), Decoration::kTrv};
  const double hi = starts_at_pole ? kInfinity : rounded(mpfr_cot, x.lo(), MPFR_RNDU);
  const double lo = ends_at_pole ? -kInfinity : rounded(mpfr_cot, x.hi(), MPFR_RNDD);
  return {Interval::from_bounds(lo, hi),
          starts_at_pole || ends_at_pole ? Decoration::kTrv : Decoration::kCom};
}

namespace {

// 1 / w(x) for a wave w: between two poles it has one sign and one turning point with value +-1.
Evaluated inverse_wave(RealFunction f, const Interval& x, const Quarters& q, int pole,
                       bool zero_is_pole) {
  const bool starts = zero_is_pole && order_key(x.lo()) == 0,
             ends = zero_is_pole && order_key(x.hi()) == 0;
  Quarters inside = q;
  if (ends) --inside.hi;
  if (passes(inside, pole) || passes(inside, (pole + 2) % 4))
    return {Interval::entire(), Decoration::kTrv};
  // Positive in the two quarters after `pole`; the turning point is between them.
  const bool positive = (inside.lo - pole + 4) % 4 < 2;
  const bool turns = passes(inside, (pole + 1) % 4) || passes(inside, (pole + 3) % 4);
  const auto end = [&](double v, bool at_pole, mpfr_rnd_t direction) {
    if (at_pole) return positive ? kInfinity : -kInfinity;
    return rounded(f, v, direction);
  };
  double lo = std::min(end(x.lo(), starts, MPFR_RNDD), end(x.hi(), ends, MPFR_RNDD));
  double hi = std::max(end(x.lo(), starts, MPFR_RNDU), end(x.hi(), ends, MPFR_RNDU));
  if (turns) (positive ? lo : hi) = positive ? 1 : -1;
  return {Interval::from_bounds(lo, hi), starts || ends ? Decoration::kTrv : Decoration::kCom};
}

}  // namespace

Evaluated eval_csc(const Interval& x) {
  if (x.is_empty() || x.sign() == Sign3::kZero) return no_value();
  if (!is_common(x)) return {Interval::entire(), Decoration::kTrv};
  const MpfrScope environment;
  return inverse_wave(mpfr_csc, x, quarters(x), 0, true);
}

Evaluated eval_sec(const Interval& x) {
  if (x.is_empty()) return no_value();
  if (!is_common(x)) return {Interval::entire(), Decoration::kTrv};
  const MpfrScope environment;
  return inverse_wave(mpfr_sec, x, quarters(x), 3, false);
}

}  // namespace veritope::internal
