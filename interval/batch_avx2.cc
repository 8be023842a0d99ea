// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_avx2.cc: four lanes, in the rounding mode of the thread, upward. Compiled with the
// flags of its instruction set: see batch_internal.h.
#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>

#include "interval/batch_loops_internal.h"

namespace veritope {
namespace {

// All ones in the first `count` of four, when read at [4 - count].
alignas(32) constexpr long long kFirst[8] = {-1, -1, -1, -1, 0, 0, 0, 0};

// Operands are loaded from memory and results are stored there, so that neither can pass the caller's change of the
// rounding mode; no expression has constant operands.
struct Lanes4 {
  static constexpr std::size_t kLanes = 4;
  static constexpr bool kUpward = true, kFused = true;
  using Mask = __m256d;
  using V = Lanes4;
  __m256d v;

  static __m256i first(std::size_t count) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(kFirst + 4 - count));
  }
  static V load(const double* p) { return {_mm256_loadu_pd(p)}; }
  static V load_part(const double* p, std::size_t count) {
    return {_mm256_maskload_pd(p, first(count))};
  }
  static void store(double* p, V a) { _mm256_storeu_pd(p, a.v); }
  static void store_part(double* p, V a, std::size_t count) {
    _mm256_maskstore_pd(p, first(count), a.v);
  }
  static V all(double x) { return {_mm256_set1_pd(x)}; }
  static V zero() { return {_mm256_setzero_pd()}; }

  static V add(V a, V b) { return {_mm256_add_pd(a.v, b.v)}; }
  static V mul(V a, V b) { return {_mm256_mul_pd(a.v, b.v)}; }
  static V div(V a, V b) { return {_mm256_div_pd(a.v, b.v)}; }
  static V fma(V a, V b, V c) { return {_mm256_fmadd_pd(a.v, b.v, c.v)}; }
  static V outward(V a) { return a; }

  static V larger(V a, V b) { return {_mm256_max_pd(a.v, b.v)}; }
  static V abs(V a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)}; }
  static V negative(V a) {
    __m256d r = _mm256_xor_pd(a.v, _mm256_set1_pd(-0.0));
    asm("" : "+x"(r));  // otherwise the compiler turns (-x) y into -(x y)
    return {r};
  }
  static V by_sign(V sign, V plus, V minus) { return {_mm256_blendv_pd(plus.v, minus.v, sign.v)}; }
  static Mask less(V a, V b) { return _mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ); }
  static Mask equal(V a, V b) { return _mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ); }
  static Mask is_unordered(V a, V b) { return _mm256_cmp_pd(a.v, b.v, _CMP_UNORD_Q); }
  static V select(Mask mask, V yes, V no) { return {_mm256_blendv_pd(no.v, yes.v, mask)}; }
  static Mask either(Mask a, Mask b) { return _mm256_or_pd(a, b); }
  static Mask both(Mask a, Mask b) { return _mm256_and_pd(a, b); }
  static bool any(Mask a) { return _mm256_movemask_pd(a) != 0; }
};

constexpr BatchKernels kKernels = kernels_of<Lanes4>();

}  // namespace

const BatchKernels* internal::batch_avx2() { return &kKernels; }

}  // namespace veritope
#else
#include "interval/batch_internal.h"

const veritope::BatchKernels* veritope::internal::batch_avx2() { return nullptr; }
#endif
