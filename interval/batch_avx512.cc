// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_avx512.cc: eight lanes; the rounding direction is in the instructions. Compiled with
// the flags of its instruction set: see batch_internal.h.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <immintrin.h>

#include "interval/batch_loops_internal.h"

namespace veritope {
namespace {

constexpr int kUp = _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC;

struct Lanes8 {
  static constexpr std::size_t kLanes = 8;
  static constexpr bool kUpward = true, kFused = true;
  using Mask = __mmask8;
  using V = Lanes8;
  __m512d v;

  static __mmask8 first(std::size_t count) { return static_cast<__mmask8>((1u << count) - 1); }
  static V load(const double* p) { return {_mm512_loadu_pd(p)}; }
  static V load_part(const double* p, std::size_t count) {
    return {_mm512_maskz_loadu_pd(first(count), p)};
  }
  static void store(double* p, V a) { _mm512_storeu_pd(p, a.v); }
  static void store_part(double* p, V a, std::size_t count) {
    _mm512_mask_storeu_pd(p, first(count), a.v);
  }
  static V all(double x) { return {_mm512_set1_pd(x)}; }
  static V zero() { return {_mm512_setzero_pd()}; }

  static V add(V a, V b) { return {_mm512_add_round_pd(a.v, b.v, kUp)}; }
  static V mul(V a, V b) { return {_mm512_mul_round_pd(a.v, b.v, kUp)}; }
  static V div(V a, V b) { return {_mm512_div_round_pd(a.v, b.v, kUp)}; }
  static V fma(V a, V b, V c) { return {_mm512_fmadd_round_pd(a.v, b.v, c.v, kUp)}; }
  static V outward(V a) { return a; }

  static V larger(V a, V b) { return {_mm512_max_pd(a.v, b.v)}; }
  static V abs(V a) { return {_mm512_abs_pd(a.v)}; }
  static V negative(V a) { return {_mm512_xor_pd(a.v, _mm512_set1_pd(-0.0))}; }
  static V by_sign(V sign, V plus, V minus) {
    const Mask is_minus = _mm512_movepi64_mask(_mm512_castpd_si512(sign.v));
    return {_mm512_mask_blend_pd(is_minus, plus.v, minus.v)};
  }
  static Mask less(V a, V b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ); }
  static Mask equal(V a, V b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ); }
  static Mask is_unordered(V a, V b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_UNORD_Q); }
  static V select(Mask mask, V yes, V no) { return {_mm512_mask_blend_pd(mask, no.v, yes.v)}; }
  static Mask either(Mask a, Mask b) { return static_cast<Mask>(a | b); }
  static Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
  static bool any(Mask a) { return a != 0; }
};

constexpr BatchKernels kKernels = kernels_of<Lanes8>();

}  // namespace

const BatchKernels* internal::batch_avx512() { return &kKernels; }

}  // namespace veritope
#else
#include "interval/batch_internal.h"

const veritope::BatchKernels* veritope::internal::batch_avx512() { return nullptr; }
#endif
