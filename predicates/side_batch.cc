// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/side_batch.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <algorithm>

#include "predicates/side_batch_internal.h"
#include "robust/base/fp_guard.h"

namespace veritope {
namespace internal {
namespace {

#if defined(__SSE2__)
struct Lanes2 {
  static constexpr std::size_t kLanes = 2;
  using V = Lanes2;
  __m128d v;

  static V load(const double* p) { return {_mm_loadu_pd(p)}; }
  static V load_part(const double* p, std::size_t) { return {_mm_load_sd(p)}; }
  static V all(double x) { return {_mm_set1_pd(x)}; }
  static V add(V a, V b) { return {_mm_add_pd(a.v, b.v)}; }
  static V sub(V a, V b) { return {_mm_sub_pd(a.v, b.v)}; }
  static V mul(V a, V b) { return {_mm_mul_pd(a.v, b.v)}; }
  static V abs(V a) { return {_mm_andnot_pd(_mm_set1_pd(-0.0), a.v)}; }
  static void store_signs(V det, V error, int* out, std::size_t count) {
    const __m128d minus = _mm_xor_pd(det.v, _mm_set1_pd(-0.0));
    const __m128i above = _mm_castpd_si128(_mm_cmpgt_pd(det.v, error.v));
    const __m128i below = _mm_castpd_si128(_mm_cmpgt_pd(minus, error.v));
    // 2 + (-1 if above) + (-3 if below), then the low halves.
    const __m128i three = _mm_and_si128(below, _mm_set1_epi32(3));
    const __m128i sign = _mm_sub_epi32(_mm_add_epi32(_mm_set1_epi32(2), above), three);
    const __m128i both = _mm_shuffle_epi32(sign, 0x08);
    if (count == kLanes) {
      _mm_storel_epi64(reinterpret_cast<__m128i*>(out), both);
    } else {
      *out = _mm_cvtsi128_si32(both);
    }
  }
};
using BaselineLanes = Lanes2;
#else
struct Lanes1 {
  static constexpr std::size_t kLanes = 1;
  using V = Lanes1;
  double v;

  static V load(const double* p) { return {*p}; }
  static V load_part(const double* p, std::size_t) { return {*p}; }
  static V all(double x) { return {x}; }
  static V add(V a, V b) { return {a.v + b.v}; }
  static V sub(V a, V b) { return {a.v - b.v}; }
  static V mul(V a, V b) { return {a.v * b.v}; }
  static V abs(V a) { return {std::abs(a.v)}; }
  static void store_signs(V det, V error, int* out, std::size_t) {
    *out = static_cast<int>(sign_beyond(det.v, error.v));
  }
};
using BaselineLanes = Lanes1;
#endif

SidePlane side_plane(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const formulas::Plane3<double> p(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
  const auto sum = [](double v, double w) { return std::abs(v) + std::abs(w); };
  return {{a.x, a.y, a.z},
          {p.yz - p.zy, p.zx - p.xz, p.xy - p.yx},
          {sum(p.yz, p.zy), sum(p.zx, p.xz), sum(p.xy, p.yx)},
          kOrient3dRel,
          kOrient3dEta,
          kFilterFloor};
}

struct BackEnds {
  SideKernel kernel[3];
  std::size_t n = 0;
};
const BackEnds& back_ends() {
  static const BackEnds all = [] {
    BackEnds b;
    b.kernel[b.n++] = side_baseline;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && side_avx2() != nullptr) b.kernel[b.n++] = side_avx2();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && side_avx512() != nullptr) {
      b.kernel[b.n++] = side_avx512();
    }
#endif
    return b;
  }();
  return all;
}

}  // namespace

void side_baseline(const SidePlane& plane, const double* x, const double* y, const double* z,
                   std::size_t n, int* out) {
  SideLoop<BaselineLanes>::run(plane, x, y, z, n, out);
}

std::size_t num_side_back_ends() noexcept { return back_ends().n; }

void orient3d_filter_on(std::size_t back_end, const Vec3d& a, const Vec3d& b, const Vec3d& c,
                        const PointArrays& points, Sign3* out) noexcept {
  static_assert(sizeof(Sign3) == sizeof(int) && static_cast<int>(Sign3::kUncertain) == 2);
  if constexpr (!kFiltersAreCompiled) {
    std::fill(out, out + points.n, Sign3::kUncertain);
    return;
  }
  const ScopedDefaultFp nearest;
  back_ends().kernel[back_end](side_plane(a, b, c), points.x, points.y, points.z, points.n,
                               reinterpret_cast<int*>(out));
}

}  // namespace internal

void orient3d_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const PointArrays& points,
                     Sign3* out) noexcept {
  internal::orient3d_filter_on(internal::num_side_back_ends() - 1, a, b, c, points, out);
}

void orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const PointArrays& points, Sign* out,
              TierCounts* tally) noexcept {
  constexpr std::size_t kChunk = 512;
  Sign3 filtered[kChunk];
  for (std::size_t from = 0; from < points.n; from += kChunk) {
    const std::size_t n = std::min(kChunk, points.n - from);
    orient3d_filter(a, b, c, {points.x + from, points.y + from, points.z + from, n}, filtered);
    for (std::size_t i = 0; i < n; ++i) {
      const auto first = [&]() VT_TIER { return filtered[i]; };
      out[from + i] = cascade(tally, first, [&](TierCounts* t) VT_TIER {
        return internal::orient3d_after_filter(a, b, c, points.at(from + i), t);
      });
    }
  }
}

}  // namespace veritope
