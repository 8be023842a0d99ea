// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/decorated.h"

#include "interval/evaluate_internal.h"
#include "interval/functions.h"

namespace veritope {

namespace {

using internal::Evaluated;

template <typename... Operands>
DecoratedInterval combine(const Evaluated& result, const Operands&... operands) {
  if ((operands.is_nai() || ...)) return DecoratedInterval::nai();
  Decoration d = result.local;
  ((d = weakest(d, operands.decoration())), ...);
  return DecoratedInterval(result.value, d);
}
template <typename... Operands>
DecoratedInterval everywhere(const Interval& value, const Operands&... operands) {
  return combine(Evaluated{value, Decoration::kCom}, operands...);
}
template <typename... Operands>
DecoratedInterval nothing_known(const Interval& value, const Operands&... operands) {
  return combine(Evaluated{value, Decoration::kTrv}, operands...);
}
Decoration unless(bool undefined_somewhere) {
  return undefined_somewhere ? Decoration::kTrv : Decoration::kCom;
}

}  // namespace

DecoratedInterval::DecoratedInterval(const Interval& x) : DecoratedInterval(x, Decoration::kCom) {}

DecoratedInterval::DecoratedInterval(const Interval& x, Decoration d)
    : interval_(x), decoration_(d) {
  if (d == Decoration::kIll) {
    interval_ = Interval::empty();
  } else if (x.is_empty()) {
    decoration_ = Decoration::kTrv;
  } else if (!is_common(x)) {
    decoration_ = weakest(d, Decoration::kDac);
  }
}

DecoratedInterval DecoratedInterval::nai() {
  return DecoratedInterval(Interval::empty(), Decoration::kIll);
}

Signalled<Interval> interval_part(const DecoratedInterval& x) {
  return {x.interval(), x.is_nai() ? Signal::kIntervalPartOfNai : Signal::kNone};
}

Signalled<DecoratedInterval> set_decoration(const Interval& x, Decoration d) {
  return {DecoratedInterval(x, d),
          d == Decoration::kIll ? Signal::kUndefinedOperation : Signal::kNone};
}

Signalled<DecoratedInterval> nums_to_decorated(double lo, double hi) {
  const Signalled<Interval> bare = nums_to_interval(lo, hi);
  if (bare.signal != Signal::kNone) return {DecoratedInterval::nai(), bare.signal};
  return {DecoratedInterval(bare.value)};
}

DecoratedInterval operator-(const DecoratedInterval& a) { return everywhere(-a.interval(), a); }
DecoratedInterval operator+(const DecoratedInterval& a, const DecoratedInterval& b) {
  const ScopedUpward upward;
  return everywhere(a.interval() + b.interval(), a, b);
}
DecoratedInterval operator-(const DecoratedInterval& a, const DecoratedInterval& b) {
  const ScopedUpward upward;
  return everywhere(a.interval() - b.interval(), a, b);
}
DecoratedInterval operator*(const DecoratedInterval& a, const DecoratedInterval& b) {
  const ScopedUpward upward;
  return everywhere(a.interval() * b.interval(), a, b);
}
DecoratedInterval operator/(const DecoratedInterval& a, const DecoratedInterval& b) {
  const ScopedUpward upward;
  return combine(Evaluated{a.interval() / b.interval(), unless(is_member(0, b.interval()))}, a, b);
}

DecoratedInterval sqr(const DecoratedInterval& x) {
  const ScopedUpward upward;
  return everywhere(sqr(x.interval()), x);
}
DecoratedInterval recip(const DecoratedInterval& x) {
  const ScopedUpward upward;
  return combine(Evaluated{recip(x.interval()), unless(is_member(0, x.interval()))}, x);
}
DecoratedInterval sqrt(const DecoratedInterval& x) {
  const ScopedUpward upward;
  return combine(Evaluated{sqrt(x.interval()), unless(internal::less(x.interval().lo(), 0))}, x);
}
DecoratedInterval fma(const DecoratedInterval& a, const DecoratedInterval& b,
                      const DecoratedInterval& c) {
  return everywhere(fma(a.interval(), b.interval(), c.interval()), a, b, c);
}
DecoratedInterval pown(const DecoratedInterval& x, std::int64_t n) {
  return combine(internal::eval_pown(x.interval(), n), x);
}
DecoratedInterval rootn(const DecoratedInterval& x, std::int64_t n) {
  return combine(internal::eval_rootn(x.interval(), n), x);
}
DecoratedInterval abs(const DecoratedInterval& x) { return everywhere(abs(x.interval()), x); }
DecoratedInterval min(const DecoratedInterval& a, const DecoratedInterval& b) {
  return everywhere(min(a.interval(), b.interval()), a, b);
}
DecoratedInterval max(const DecoratedInterval& a, const DecoratedInterval& b) {
  return everywhere(max(a.interval(), b.interval()), a, b);
}

#define VT_DEFINE(name)                                     \
  DecoratedInterval name(const DecoratedInterval& x) {      \
    return combine(internal::eval_##name(x.interval()), x); \
  }
VT_INTERVAL_UNARY(VT_DEFINE)
#undef VT_DEFINE
#define VT_DEFINE(name)                                                            \
  DecoratedInterval name(const DecoratedInterval& a, const DecoratedInterval& b) { \
    return combine(internal::eval_##name(a.interval(), b.interval()), a, b);       \
  }
VT_INTERVAL_BINARY(VT_DEFINE)
#undef VT_DEFINE

DecoratedInterval intersection(const DecoratedInterval& a, const DecoratedInterval& b) {
  return nothing_known(intersection(a.interval(), b.interval()), a, b);
}
DecoratedInterval hull(const DecoratedInterval& a, const DecoratedInterval& b) {
  return nothing_known(hull(a.interval(), b.interval()), a, b);
}
DecoratedInterval cancel_minus(const DecoratedInterval& a, const DecoratedInterval& b) {
  return nothing_known(cancel_minus(a.interval(), b.interval()), a, b);
}
DecoratedInterval cancel_plus(const DecoratedInterval& a, const DecoratedInterval& b) {
  return nothing_known(cancel_plus(a.interval(), b.interval()), a, b);
}

std::string to_string(const DecoratedInterval& x) {
  const char* suffix = "";
  switch (x.decoration()) {
    case Decoration::kIll: return "[nai]";
    case Decoration::kTrv: suffix = "_trv"; break;
    case Decoration::kDef: suffix = "_def"; break;
    case Decoration::kDac: suffix = "_dac"; break;
    case Decoration::kCom: suffix = "_com"; break;
  }
  return to_string(x.interval()) + suffix;
}

}  // namespace veritope
