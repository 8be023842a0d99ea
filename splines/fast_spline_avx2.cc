// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline_avx2.cc: a vector of four lanes. Compiled with the flags of its instruction set, without fused
// operations, so that the results have the bits of the baseline's: see fast_spline_internal.h.
#if defined(__AVX2__)
#include <immintrin.h>

#include "splines/fast_spline_loops_internal.h"

namespace veritope::internal {
namespace {

struct Lanes4 {
  __m256d v;
  [[gnu::always_inline]] static Lanes4 load(const double* p) { return {_mm256_load_pd(p)}; }
  [[gnu::always_inline]] static Lanes4 load_loose(const double* p) { return {_mm256_loadu_pd(p)}; }
  [[gnu::always_inline]] static void store(double* p, Lanes4 a) { _mm256_storeu_pd(p, a.v); }
  [[gnu::always_inline]] static void store3(double* p, Lanes4 a) {
    _mm_storeu_pd(p, _mm256_castpd256_pd128(a.v));
    _mm_store_sd(p + 2, _mm256_extractf128_pd(a.v, 1));
  }
  [[gnu::always_inline]] static Lanes4 all(double x) { return {_mm256_set1_pd(x)}; }
  friend Lanes4 operator+(Lanes4 a, Lanes4 b) { return {_mm256_add_pd(a.v, b.v)}; }
  friend Lanes4 operator-(Lanes4 a, Lanes4 b) { return {_mm256_sub_pd(a.v, b.v)}; }
  friend Lanes4 operator*(Lanes4 a, Lanes4 b) { return {_mm256_mul_pd(a.v, b.v)}; }
  friend Lanes4 operator-(Lanes4 a) { return {_mm256_xor_pd(a.v, _mm256_set1_pd(-0.0))}; }
};

constexpr FastKernels kKernels = fast_kernels_of<Lanes4>();

}  // namespace

const FastKernels* fast_avx2() { return &kKernels; }

}  // namespace veritope::internal
#else
#include "splines/fast_spline_internal.h"

const veritope::internal::FastKernels* veritope::internal::fast_avx2() { return nullptr; }
#endif
