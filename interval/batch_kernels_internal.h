// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_kernels_internal.h: the array operations over a vector of binary64 lanes V, which
// each back end brings. All names are in the unnamed namespace of a back end's file.
//
// V has: kLanes, kUpward, kFused; load, store, and for 0 < count < kLanes load_part, store_part; all,
// zero; add, mul, div, fma in the back end's rounding; outward (the identity where that is upward);
// larger(a, b) = a > b ? a : b, so b if either is NaN, as x86 defines it; abs; negative(v) = -v, opaque
// to the compiler; by_sign(s, p, m) = m where the sign bit of s is set, else p; the comparisons less,
// equal, is_unordered(a, b) giving V::Mask; select(mask, yes, no); either, both, any of masks.
#pragma once
#include <cstddef>

#include "interval/batch_internal.h"

namespace veritope {
namespace {

template <typename V>
struct Lanes {
  V neg_lo, hi;
};

template <typename V>
[[gnu::always_inline]] inline Lanes<V> load(BatchIn a, std::size_t i) {
  return {V::load(a.neg_lo + i), V::load(a.hi + i)};
}
template <typename V>
[[gnu::always_inline]] inline Lanes<V> load_part(BatchIn a, std::size_t i, std::size_t count) {
  return {V::load_part(a.neg_lo + i, count), V::load_part(a.hi + i, count)};
}
template <typename V>
[[gnu::always_inline]] inline void store(const Lanes<V>& r, BatchOut out, std::size_t i) {
  V::store(out.neg_lo + i, r.neg_lo), V::store(out.hi + i, r.hi);
}
template <typename V>
[[gnu::always_inline]] inline void store_part(const Lanes<V>& r, BatchOut out, std::size_t i,
                                              std::size_t count) {
  V::store_part(out.neg_lo + i, r.neg_lo, count), V::store_part(out.hi + i, r.hi, count);
}

template <typename V>
[[gnu::always_inline]] inline Lanes<V> minus(const Lanes<V>& a) {
  return {a.hi, a.neg_lo};
}
// Only the empty set produces NaN: neither -lo nor hi is ever -infinity.
template <typename V>
[[gnu::always_inline]] inline Lanes<V> plus(const Lanes<V>& a, const Lanes<V>& b) {
  return {V::outward(V::add(a.neg_lo, b.neg_lo)), V::outward(V::add(a.hi, b.hi))};
}

// The four products that can be bounds. Let lo(x b) be the lower end of x b, and hi(x b) the upper one: then a b =
// [min(lo(lo(a) b), lo(hi(a) b)), max(...)], and the sign of x decides which end of b gives which.
// No product is negated: compilers turn (-x) y into -(x y), which rounds the other way.
template <typename V>
struct Products {
  V low_at_hi, low_at_lo, high_at_hi, high_at_lo;  // "low": candidates for -lo(a b)

  Products() = default;
  [[gnu::always_inline]] Products(const Lanes<V>& a, const Lanes<V>& b) {
    const V x = V::abs(a.hi), y = V::abs(a.neg_lo);
    low_at_hi = V::mul(x, V::by_sign(a.hi, b.neg_lo, b.hi));
    low_at_lo = V::mul(y, V::by_sign(a.neg_lo, b.hi, b.neg_lo));
    high_at_hi = V::mul(x, V::by_sign(a.hi, b.hi, b.neg_lo));
    high_at_lo = V::mul(y, V::by_sign(a.neg_lo, b.neg_lo, b.hi));
  }
  [[gnu::always_inline]] Lanes<V> hull() const {
    return {V::outward(V::larger(low_at_hi, low_at_lo)),
            V::outward(V::larger(high_at_hi, high_at_lo))};
  }
  [[gnu::always_inline]] bool has_nan() const {
    return V::any(
        V::either(V::is_unordered(low_at_hi, low_at_lo), V::is_unordered(high_at_hi, high_at_lo)));
  }
};

template <typename V>
[[gnu::always_inline]] inline typename V::Mask is_empty(const Lanes<V>& a) {
  return V::is_unordered(a.neg_lo, a.hi);
}
template <typename V>
[[gnu::always_inline]] inline Lanes<V> empty_where(typename V::Mask mask, const Lanes<V>& r) {
  const V nan = V::all(__builtin_nan(""));
  return {V::select(mask, nan, r.neg_lo), V::select(mask, nan, r.hi)};
}
template <typename V>
[[gnu::always_inline]] inline V zero_if_nan(const V& v) {
  return V::select(V::is_unordered(v, v), V::zero(), v);
}

// Accepts any operands: the processor makes 0 * infinity NaN, but as a product of sets it is {0}.
template <typename V>
[[gnu::noinline]] Lanes<V> careful_times(const Lanes<V>& a, const Lanes<V>& b) {
  Products<V> p(a, b);
  p.low_at_hi = zero_if_nan(p.low_at_hi), p.low_at_lo = zero_if_nan(p.low_at_lo);
  p.high_at_hi = zero_if_nan(p.high_at_hi), p.high_at_lo = zero_if_nan(p.high_at_lo);
  return empty_where(V::either(is_empty(a), is_empty(b)), p.hull());
}
template <typename V>
[[gnu::always_inline]] inline Lanes<V> times(const Lanes<V>& a, const Lanes<V>& b) {
  const Products<V> p(a, b);
  if (p.has_nan()) [[unlikely]]
    return careful_times(a, b);
  return p.hull();
}

// A chain of operations may use quick_times, look at its result once, and repeat with the careful functions if that
// result is_suspect. Claim: every result is right, or suspect (a bound is NaN or infinite). Proof: let a and b be right
// or suspect. If all bounds are finite, no product is NaN. If b has an infinite or NaN bound and a is not {0}, by_sign
// pairs that bound with a bound of a that is not 0, in the first product of `larger`, whose infinity survives, or in
// the second, which survives anyway, of neg_lo or of hi; the tests run through the four signs of a's bounds, each with
// its pairing. If a is {0}, the result is {0}, which is right, or NaN. Sums keep NaN and +infinity. Underflow and
// overflow are as in the careful functions.
template <typename V>
[[gnu::always_inline]] inline Lanes<V> quick_times(const Lanes<V>& a, const Lanes<V>& b) {
  return Products<V>(a, b).hull();
}
template <typename V>
[[gnu::always_inline]] inline bool is_suspect(const Lanes<V>& r) {
  const V width = V::add(r.neg_lo, r.hi), infinity = V::all(__builtin_inf());
  return V::any(V::either(V::is_unordered(width, width), V::equal(width, infinity)));
}

template <typename V>
[[gnu::always_inline]] inline Lanes<V> squared(const Lanes<V>& a) {
  const V far = V::larger(a.neg_lo, a.hi);
  const V lo = V::negative(a.neg_lo), above = V::negative(a.hi);
  const V near = V::larger(V::zero(), V::larger(lo, above));  // the least |x|; NaN stays
  V low = V::outward(V::mul(V::negative(near), near));
  if constexpr (!V::kUpward) low = V::select(V::less(V::zero(), low), V::zero(), low);
  return {low, V::outward(V::mul(far, far))};
}

// a / b for b >= 0 or, with both negated, for b <= 0: each bound of a is divided by the end of b that its sign
// selects. If b begins at 0, x / 0 is the infinity that bounds the quotients, and 0 / 0 stands for 0.
template <typename V>
[[gnu::always_inline]] inline Lanes<V> quotient(const Lanes<V>& a, const Lanes<V>& b) {
  const V zero = V::zero(), infinity = V::all(__builtin_inf());
  const auto goes_up = V::less(zero, b.hi), goes_down = V::less(zero, b.neg_lo);
  const V num_low = V::select(goes_up, a.neg_lo, a.hi),
          num_high = V::select(goes_up, a.hi, a.neg_lo);
  const V near = V::abs(V::select(goes_up, b.neg_lo, b.hi));
  const V far = V::select(goes_up, b.hi, b.neg_lo);
  V low = V::outward(zero_if_nan(V::div(num_low, V::by_sign(num_low, near, far))));
  V high = V::outward(zero_if_nan(V::div(num_high, V::by_sign(num_high, near, far))));
  const auto straddles = V::both(goes_up, goes_down);
  low = V::select(straddles, infinity, low), high = V::select(straddles, infinity, high);
  const auto is_zero = V::both(V::equal(a.neg_lo, zero), V::equal(a.hi, zero));
  low = V::select(is_zero, zero, low), high = V::select(is_zero, zero, high);
  const auto by_zero = V::both(V::equal(b.neg_lo, zero), V::equal(b.hi, zero));
  return empty_where(V::either(by_zero, V::either(is_empty(a), is_empty(b))), Lanes<V>{low, high});
}

// x y + c for the candidates x y of Products. If Careful, 0 * infinity is 0, and infinity - infinity comes from a
// product of -infinity, which is not the bound.
template <typename V, bool Careful>
[[gnu::always_inline]] inline V fused(const V& x, const V& y, const V& c) {
  const V r = V::fma(x, y, c);
  if constexpr (!Careful) return r;
  const auto is_zero = V::either(V::equal(x, V::zero()), V::equal(y, V::zero()));
  const V fixed = V::select(is_zero, c, V::all(-__builtin_inf()));
  return V::select(V::is_unordered(r, r), fixed, r);
}
template <typename V, bool Careful>
[[gnu::always_inline]] inline Products<V> fused_products(const Lanes<V>& a, const Lanes<V>& b,
                                                         const Lanes<V>& c) {
  const V x = V::abs(a.hi), y = V::abs(a.neg_lo);
  Products<V> p;
  p.low_at_hi = fused<V, Careful>(x, V::by_sign(a.hi, b.neg_lo, b.hi), c.neg_lo);
  p.low_at_lo = fused<V, Careful>(y, V::by_sign(a.neg_lo, b.hi, b.neg_lo), c.neg_lo);
  p.high_at_hi = fused<V, Careful>(x, V::by_sign(a.hi, b.hi, b.neg_lo), c.hi);
  p.high_at_lo = fused<V, Careful>(y, V::by_sign(a.neg_lo, b.neg_lo, b.hi), c.hi);
  return p;
}
template <typename V>
[[gnu::noinline]] Lanes<V> careful_fused(const Lanes<V>& a, const Lanes<V>& b, const Lanes<V>& c) {
  return empty_where(V::either(is_empty(a), V::either(is_empty(b), is_empty(c))),
                     fused_products<V, true>(a, b, c).hull());
}
template <typename V>
[[gnu::always_inline]] inline Lanes<V> times_plus(const Lanes<V>& a, const Lanes<V>& b,
                                                  const Lanes<V>& c) {
  if constexpr (V::kFused) {
    const Products<V> p = fused_products<V, false>(a, b, c);
    if (p.has_nan()) [[unlikely]]
      return careful_fused(a, b, c);
    return p.hull();
  } else {
    return plus(times(a, b), c);
  }
}

template <typename V>
struct QuickTimes {
  [[gnu::always_inline]] Lanes<V> operator()(const Lanes<V>& a, const Lanes<V>& b) const {
    return quick_times(a, b);
  }
};
template <typename V>
struct CarefulTimes {
  Lanes<V> operator()(const Lanes<V>& a, const Lanes<V>& b) const { return careful_times(a, b); }
};

}  // namespace
}  // namespace veritope
