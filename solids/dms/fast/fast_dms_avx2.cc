// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_dms_avx2.cc: a vector of four lanes. Compiled with the flags of its instruction set, without
// fused operations, so that the results have the bits of the baseline's: see fast_dms_internal.h.
#if defined(__AVX2__)
#include <immintrin.h>

#include "solids/dms/fast/fast_dms_loops_internal.h"

namespace veritope::internal {
namespace {

struct DmsLanes4 {
  __m256d v;
  [[gnu::always_inline]] static DmsLanes4 load(const double* p) { return {_mm256_loadu_pd(p)}; }
  [[gnu::always_inline]] static void store(double* p, DmsLanes4 a) { _mm256_storeu_pd(p, a.v); }
  [[gnu::always_inline]] static DmsLanes4 all(double x) { return {_mm256_set1_pd(x)}; }
  [[gnu::always_inline]] static DmsLanes4 four(double a, double b, double c, double d) {
    return {_mm256_set_pd(d, c, b, a)};
  }
  friend DmsLanes4 operator+(DmsLanes4 a, DmsLanes4 b) { return {_mm256_add_pd(a.v, b.v)}; }
  friend DmsLanes4 operator-(DmsLanes4 a, DmsLanes4 b) { return {_mm256_sub_pd(a.v, b.v)}; }
  friend DmsLanes4 operator*(DmsLanes4 a, DmsLanes4 b) { return {_mm256_mul_pd(a.v, b.v)}; }
  [[gnu::always_inline]] static DmsLanes4 min(DmsLanes4 a, DmsLanes4 b) {
    return {_mm256_min_pd(a.v, b.v)};
  }
  [[gnu::always_inline]] static DmsLanes4 max(DmsLanes4 a, DmsLanes4 b) {
    return {_mm256_max_pd(a.v, b.v)};
  }
  [[gnu::always_inline]] static DmsLanes4 abs(DmsLanes4 a) {
    return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)};
  }
  // Masks: all bits of a lane, or none.
  [[gnu::always_inline]] static DmsLanes4 less(DmsLanes4 a, DmsLanes4 b) {
    return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)};
  }
  [[gnu::always_inline]] static DmsLanes4 without(DmsLanes4 a, DmsLanes4 mask) {
    return {_mm256_andnot_pd(mask.v, a.v)};
  }
  [[gnu::always_inline]] static DmsLanes4 either(DmsLanes4 a, DmsLanes4 b) {
    return {_mm256_or_pd(a.v, b.v)};
  }
  [[gnu::always_inline]] static unsigned bits(DmsLanes4 mask) {
    return static_cast<unsigned>(_mm256_movemask_pd(mask.v));
  }
  [[gnu::always_inline]] static bool any(DmsLanes4 mask) { return bits(mask) != 0; }
  [[gnu::always_inline]] static bool lane(DmsLanes4 mask, std::size_t l) {
    return ((bits(mask) >> l) & 1) != 0;
  }
};

constexpr FastDmsKernels kDmsKernels = fast_dms_kernels_of<DmsLanes4>();

}  // namespace

const FastDmsKernels* fast_dms_avx2() { return &kDmsKernels; }

}  // namespace veritope::internal
#else
#include "solids/dms/fast/fast_dms_internal.h"

const veritope::internal::FastDmsKernels* veritope::internal::fast_dms_avx2() { return nullptr; }
#endif
