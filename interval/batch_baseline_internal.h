// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_baseline_internal.h: two lanes of SSE2, or one anywhere else, in the rounding mode of
// the thread.
#pragma once
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "interval/batch_loops_internal.h"

namespace veritope {
namespace {

#if defined(__SSE2__)
template <typename V>
struct BaselineLanes {
  static constexpr std::size_t kLanes = 2;
  using Mask = __m128d;
  __m128d v;

  static V load(const double* p) { return make(_mm_loadu_pd(p)); }
  static V load_part(const double* p, std::size_t) { return make(_mm_load_sd(p)); }
  static void store(double* p, V a) { _mm_storeu_pd(p, a.v); }
  static void store_part(double* p, V a, std::size_t) { _mm_store_sd(p, a.v); }
  static V all(double x) { return make(_mm_set1_pd(x)); }
  static V zero() { return make(_mm_setzero_pd()); }

  static V add(V a, V b) { return make(_mm_add_pd(a.v, b.v)); }
  static V mul(V a, V b) { return make(_mm_mul_pd(a.v, b.v)); }
  static V div(V a, V b) { return make(_mm_div_pd(a.v, b.v)); }
  static V fma(V a, V b, V c) {
    double x[2], y[2], z[2];
    _mm_storeu_pd(x, a.v), _mm_storeu_pd(y, b.v), _mm_storeu_pd(z, c.v);
    for (int k = 0; k < 2; ++k) z[k] = __builtin_fma(x[k], y[k], z[k]);
    return make(_mm_loadu_pd(z));
  }

  static V larger(V a, V b) { return make(_mm_max_pd(a.v, b.v)); }
  static V abs(V a) { return make(_mm_andnot_pd(_mm_set1_pd(-0.0), a.v)); }
  static V negative(V a) {
    __m128d r = _mm_xor_pd(a.v, _mm_set1_pd(-0.0));
    asm("" : "+x"(r));  // otherwise the compiler turns (-x) y into -(x y)
    return make(r);
  }
  static V by_sign(V sign, V plus, V minus) {
    const __m128i halves = _mm_srai_epi32(_mm_castpd_si128(sign.v), 31);
    return select(_mm_castsi128_pd(_mm_shuffle_epi32(halves, 0xf5)), minus, plus);
  }
  static Mask less(V a, V b) { return _mm_cmplt_pd(a.v, b.v); }
  static Mask equal(V a, V b) { return _mm_cmpeq_pd(a.v, b.v); }
  static Mask is_unordered(V a, V b) { return _mm_cmpunord_pd(a.v, b.v); }
  static V select(Mask mask, V yes, V no) {
    return make(_mm_or_pd(_mm_and_pd(mask, yes.v), _mm_andnot_pd(mask, no.v)));
  }
  static Mask either(Mask a, Mask b) { return _mm_or_pd(a, b); }
  static Mask both(Mask a, Mask b) { return _mm_and_pd(a, b); }
  static bool any(Mask a) { return _mm_movemask_pd(a) != 0; }

  static V make(__m128d v) {
    V r;
    r.v = v;
    return r;
  }
};
#else
template <typename V>
struct BaselineLanes {
  static constexpr std::size_t kLanes = 1;
  using Mask = bool;
  double v;

  static V load(const double* p) { return make(*p); }
  static V load_part(const double* p, std::size_t) { return make(*p); }
  static void store(double* p, V a) { *p = a.v; }
  static void store_part(double* p, V a, std::size_t) { *p = a.v; }
  static V all(double x) { return make(x); }
  static V zero() { return make(0); }

  static V add(V a, V b) { return make(a.v + b.v); }
  static V mul(V a, V b) { return make(a.v * b.v); }
  static V div(V a, V b) { return make(a.v / b.v); }
  static V fma(V a, V b, V c) { return make(__builtin_fma(a.v, b.v, c.v)); }

  static V larger(V a, V b) { return a.v > b.v ? a : b; }
  static V abs(V a) { return make(__builtin_fabs(a.v)); }
  static V negative(V a) {
    double r = -a.v;
    asm("" : "+m"(r));  // otherwise the compiler turns (-x) y into -(x y)
    return make(r);
  }
  static V by_sign(V sign, V plus, V minus) { return __builtin_signbit(sign.v) ? minus : plus; }
  static Mask less(V a, V b) { return a.v < b.v; }
  static Mask equal(V a, V b) { return a.v == b.v; }
  static Mask is_unordered(V a, V b) { return __builtin_isunordered(a.v, b.v); }
  static V select(Mask mask, V yes, V no) { return mask ? yes : no; }
  static Mask either(Mask a, Mask b) { return a || b; }
  static Mask both(Mask a, Mask b) { return a && b; }
  static bool any(Mask a) { return a; }

  static V make(double v) {
    V r;
    r.v = v;
    return r;
  }
};
#endif

}  // namespace
}  // namespace veritope
