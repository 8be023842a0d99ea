// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/side_batch_avx2.cc: two vectors of four lanes. Compiled with the flags of its instruction
// set.
#include "predicates/side_batch_internal.h"
#if defined(__AVX2__)
#include <immintrin.h>

namespace veritope::internal {
namespace {

struct Lanes8 {
  static constexpr std::size_t kLanes = 8;
  using V = Lanes8;
  __m256d v, w;

  static V load(const double* p) { return {_mm256_loadu_pd(p), _mm256_loadu_pd(p + 4)}; }
  static V load_part(const double* p, std::size_t count) {
    double part[kLanes] = {};
    for (std::size_t k = 0; k < count; ++k) part[k] = p[k];
    return load(part);
  }
  static V all(double x) { return {_mm256_set1_pd(x), _mm256_set1_pd(x)}; }
  static V add(V a, V b) { return {_mm256_add_pd(a.v, b.v), _mm256_add_pd(a.w, b.w)}; }
  static V sub(V a, V b) { return {_mm256_sub_pd(a.v, b.v), _mm256_sub_pd(a.w, b.w)}; }
  static V mul(V a, V b) { return {_mm256_mul_pd(a.v, b.v), _mm256_mul_pd(a.w, b.w)}; }
  static V abs(V a) {
    const __m256d sign = _mm256_set1_pd(-0.0);
    return {_mm256_andnot_pd(sign, a.v), _mm256_andnot_pd(sign, a.w)};
  }
  // The high (Part 0xdd) or low (0x88) 32 bits of all lanes, in the order 0 1 4 5 2 3 6 7.
  template <int Part>
  static __m256i halves(__m256d v, __m256d w) {
    return _mm256_castps_si256(_mm256_shuffle_ps(_mm256_castpd_ps(v), _mm256_castpd_ps(w), Part));
  }
  static void store_signs(V det, V error, int* out, std::size_t count) {
    const V size = abs(det);
    const __m256i is_certain = halves<0x88>(_mm256_cmp_pd(size.v, error.v, _CMP_GT_OQ),
                                            _mm256_cmp_pd(size.w, error.w, _CMP_GT_OQ));
    const __m256i minus = _mm256_srai_epi32(halves<0xdd>(det.v, det.w), 31);  // -1 or 0
    const __m256i sign = _mm256_or_si256(minus, _mm256_set1_epi32(1));
    const __m256i mixed = _mm256_blendv_epi8(_mm256_set1_epi32(2), sign, is_certain);
    const __m256i result = _mm256_permute4x64_epi64(mixed, 0xd8);
    if (count == kLanes) {
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), result);
    } else {
      alignas(32) int part[kLanes];
      _mm256_store_si256(reinterpret_cast<__m256i*>(part), result);
      for (std::size_t k = 0; k < count; ++k) out[k] = part[k];
    }
  }
};

}  // namespace

SideKernel side_avx2() { return SideLoop<Lanes8>::run; }

}  // namespace veritope::internal
#else
veritope::internal::SideKernel veritope::internal::side_avx2() { return nullptr; }
#endif
