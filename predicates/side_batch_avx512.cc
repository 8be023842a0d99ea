// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/side_batch_avx512.cc: eight lanes. Compiled with the flags of its instruction set.
#include "predicates/side_batch_internal.h"
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include <immintrin.h>

namespace veritope::internal {
namespace {

struct Lanes8 {
  static constexpr std::size_t kLanes = 8;
  using V = Lanes8;
  __m512d v;

  static __mmask8 first(std::size_t count) { return static_cast<__mmask8>((1u << count) - 1); }
  static V load(const double* p) { return {_mm512_loadu_pd(p)}; }
  static V load_part(const double* p, std::size_t count) {
    return {_mm512_maskz_loadu_pd(first(count), p)};
  }
  static V all(double x) { return {_mm512_set1_pd(x)}; }
  static V add(V a, V b) { return {_mm512_add_pd(a.v, b.v)}; }
  static V sub(V a, V b) { return {_mm512_sub_pd(a.v, b.v)}; }
  static V mul(V a, V b) { return {_mm512_mul_pd(a.v, b.v)}; }
  static V abs(V a) { return {_mm512_abs_pd(a.v)}; }
  static void store_signs(V det, V error, int* out, std::size_t count) {
    const __m512d minus = _mm512_xor_pd(det.v, _mm512_set1_pd(-0.0));
    const __mmask8 above = _mm512_cmp_pd_mask(det.v, error.v, _CMP_GT_OQ);
    const __mmask8 below = _mm512_cmp_pd_mask(minus, error.v, _CMP_GT_OQ);
    __m256i sign = _mm256_mask_blend_epi32(above, _mm256_set1_epi32(2), _mm256_set1_epi32(1));
    sign = _mm256_mask_blend_epi32(below, sign, _mm256_set1_epi32(-1));
    if (count == kLanes) {
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), sign);
    } else {
      _mm256_mask_storeu_epi32(out, first(count), sign);
    }
  }
};

}  // namespace

SideKernel side_avx512() { return SideLoop<Lanes8>::run; }

}  // namespace veritope::internal
#else
veritope::internal::SideKernel veritope::internal::side_avx512() { return nullptr; }
#endif
