// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/decorated.h: an interval that carries what is known about the function that made it.
// Source: [IEEE1788] 8 and its simplification 1788.1.
#pragma once
#include <cstdint>
#include <string>

#include "interval/decoration.h"
#include "interval/interval.h"
#include "interval/numeric.h"
#include "interval/relations.h"
#include "interval/signal.h"

namespace veritope {

/// An interval and a decoration, such that
///   (1) kCom implies nonempty and bounded; an empty interval has kTrv or kIll;
///   (2) kIll, "NaI": no interval; the interval part is then empty, and every operation gives NaI.
/// Laws of every operation f below, on x: the interval part is that of f in interval.h, functions.h
/// and relations.h; the decoration is the weakest among those of the operands and that of f on them. A chain of
/// operations that starts with kCom constants and ends with kDac therefore proves that the whole expression is
/// defined and continuous on the box. No ScopedUpward is needed.
class DecoratedInterval {
 public:
  /// [0, 0]_com.
  DecoratedInterval() = default;
  /// The strongest decoration that fits: com, dac if unbounded, trv if empty.
  explicit DecoratedInterval(const Interval& x);
  /// x with the decoration d, or with the strongest weaker one that fits; NaI if d is kIll.
  DecoratedInterval(const Interval& x, Decoration d);
  static DecoratedInterval nai();

  Decoration decoration() const { return decoration_; }
  bool is_nai() const { return decoration_ == Decoration::kIll; }
  /// Empty for NaI.
  const Interval& interval() const { return interval_; }

  friend DecoratedInterval operator-(const DecoratedInterval& a);
  friend DecoratedInterval operator+(const DecoratedInterval& a, const DecoratedInterval& b);
  friend DecoratedInterval operator-(const DecoratedInterval& a, const DecoratedInterval& b);
  friend DecoratedInterval operator*(const DecoratedInterval& a, const DecoratedInterval& b);
  friend DecoratedInterval operator/(const DecoratedInterval& a, const DecoratedInterval& b);

 private:
  Interval interval_;
  Decoration decoration_ = Decoration::kCom;
};

/// The interval part; signals kIntervalPartOfNai for NaI.
Signalled<Interval> interval_part(const DecoratedInterval& x);
/// DecoratedInterval(x, d); signals kUndefinedOperation if d is kIll.
Signalled<DecoratedInterval> set_decoration(const Interval& x, Decoration d);
/// [lo, hi] with the strongest decoration; otherwise NaI, which signals kUndefinedOperation.
Signalled<DecoratedInterval> nums_to_decorated(double lo, double hi);

DecoratedInterval sqr(const DecoratedInterval& x);
DecoratedInterval recip(const DecoratedInterval& x);
DecoratedInterval sqrt(const DecoratedInterval& x);
DecoratedInterval fma(const DecoratedInterval& a, const DecoratedInterval& b,
                      const DecoratedInterval& c);
DecoratedInterval pown(const DecoratedInterval& x, std::int64_t n);
DecoratedInterval rootn(const DecoratedInterval& x, std::int64_t n);
DecoratedInterval abs(const DecoratedInterval& x);
DecoratedInterval min(const DecoratedInterval& a, const DecoratedInterval& b);
DecoratedInterval max(const DecoratedInterval& a, const DecoratedInterval& b);

// The functions of functions.h.
DecoratedInterval pow(const DecoratedInterval& a, const DecoratedInterval& b);
DecoratedInterval atan2(const DecoratedInterval& y, const DecoratedInterval& x);
DecoratedInterval hypot(const DecoratedInterval& a, const DecoratedInterval& b);
DecoratedInterval exp(const DecoratedInterval& x);
DecoratedInterval exp2(const DecoratedInterval& x);
DecoratedInterval exp10(const DecoratedInterval& x);
DecoratedInterval expm1(const DecoratedInterval& x);
DecoratedInterval log(const DecoratedInterval& x);
DecoratedInterval log2(const DecoratedInterval& x);
DecoratedInterval log10(const DecoratedInterval& x);
DecoratedInterval logp1(const DecoratedInterval& x);
DecoratedInterval sin(const DecoratedInterval& x);
DecoratedInterval cos(const DecoratedInterval& x);
DecoratedInterval tan(const DecoratedInterval& x);
DecoratedInterval cot(const DecoratedInterval& x);
DecoratedInterval sec(const DecoratedInterval& x);
DecoratedInterval csc(const DecoratedInterval& x);
DecoratedInterval asin(const DecoratedInterval& x);
DecoratedInterval acos(const DecoratedInterval& x);
DecoratedInterval atan(const DecoratedInterval& x);
DecoratedInterval acot(const DecoratedInterval& x);
DecoratedInterval sinh(const DecoratedInterval& x);
DecoratedInterval cosh(const DecoratedInterval& x);
DecoratedInterval tanh(const DecoratedInterval& x);
DecoratedInterval coth(const DecoratedInterval& x);
DecoratedInterval sech(const DecoratedInterval& x);
DecoratedInterval csch(const DecoratedInterval& x);
DecoratedInterval asinh(const DecoratedInterval& x);
DecoratedInterval acosh(const DecoratedInterval& x);
DecoratedInterval atanh(const DecoratedInterval& x);
DecoratedInterval acoth(const DecoratedInterval& x);
DecoratedInterval cbrt(const DecoratedInterval& x);
DecoratedInterval sign_function(const DecoratedInterval& x);
DecoratedInterval ceil(const DecoratedInterval& x);
DecoratedInterval floor(const DecoratedInterval& x);
DecoratedInterval trunc(const DecoratedInterval& x);
DecoratedInterval round_ties_to_even(const DecoratedInterval& x);
DecoratedInterval round_ties_to_away(const DecoratedInterval& x);

/// These are not functions of points: the result has kTrv, or is NaI.
DecoratedInterval intersection(const DecoratedInterval& a, const DecoratedInterval& b);
DecoratedInterval hull(const DecoratedInterval& a, const DecoratedInterval& b);
DecoratedInterval cancel_minus(const DecoratedInterval& a, const DecoratedInterval& b);
DecoratedInterval cancel_plus(const DecoratedInterval& a, const DecoratedInterval& b);

/// "[lo, hi]_com", the interval as to_string writes it; "[nai]".
std::string to_string(const DecoratedInterval& x);

}  // namespace veritope
