// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/side_batch_avx2.cc: four lanes. Compiled with the flags of its instruction set.
#include "predicates/side_batch_internal.h"
#if defined(__AVX2__)
#include <immintrin.h>

namespace veritope::internal {
namespace {

alignas(32) constexpr long long kFirst[8] = {-1, -1, -1, -1, 0, 0, 0, 0};

struct Lanes4 {
  static constexpr std::size_t kLanes = 4;
  using V = Lanes4;
  __m256d v;

  static V load(const double* p) { return {_mm256_loadu_pd(p)}; }
  static V load_part(const double* p, std::size_t count) {
    const auto* mask = reinterpret_cast<const __m256i*>(kFirst + 4 - count);
    return {_mm256_maskload_pd(p, _mm256_loadu_si256(mask))};
  }
  static V all(double x) { return {_mm256_set1_pd(x)}; }
  static V add(V a, V b) { return {_mm256_add_pd(a.v, b.v)}; }
  static V sub(V a, V b) { return {_mm256_sub_pd(a.v, b.v)}; }
  static V mul(V a, V b) { return {_mm256_mul_pd(a.v, b.v)}; }
  static V abs(V a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)}; }
  static __m128i narrow(__m256d mask) {  // to 32 bits a lane
    const __m128 low = _mm_castpd_ps(_mm256_castpd256_pd128(mask));
    const __m128 high = _mm_castpd_ps(_mm256_extractf128_pd(mask, 1));
    return _mm_castps_si128(_mm_shuffle_ps(low, high, 0x88));
  }
  static void store_signs(V det, V error, int* out, std::size_t count) {
    const __m256d minus = _mm256_xor_pd(det.v, _mm256_set1_pd(-0.0));
    const __m128i above = narrow(_mm256_cmp_pd(det.v, error.v, _CMP_GT_OQ));
    const __m128i below = narrow(_mm256_cmp_pd(minus, error.v, _CMP_GT_OQ));
    // 2 + (-1 if above) + (-3 if below)
    const __m128i three = _mm_and_si128(below, _mm_set1_epi32(3));
    const __m128i sign = _mm_sub_epi32(_mm_add_epi32(_mm_set1_epi32(2), above), three);
    if (count == kLanes) {
      _mm_storeu_si128(reinterpret_cast<__m128i*>(out), sign);
    } else {
      alignas(16) int part[4];
      _mm_store_si128(reinterpret_cast<__m128i*>(part), sign);
      for (std::size_t k = 0; k < count; ++k) out[k] = part[k];
    }
  }
};

}  // namespace

SideKernel side_avx2() { return SideLoop<Lanes4>::run; }

}  // namespace veritope::internal
#else
veritope::internal::SideKernel veritope::internal::side_avx2() { return nullptr; }
#endif
