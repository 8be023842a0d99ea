// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/mesh_lanes_internal.h"

#include <atomic>
#include <cmath>

#include "solids/vmodel/v_model.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace veritope::internal {
namespace {

std::atomic<bool> only_baseline_lanes{false};

// Bound: docs/bounds/micro_mesh.md, section 4.
constexpr double kGapError = 6 * 0x1p-53, kGapSlack = 1 + 0x1p-40, kGapTiny = 0x1p-536;

struct LaneBinomials {
  double of[kMaxVDegree + 1][kMaxVDegree + 1] = {};
  constexpr LaneBinomials() {
    for (std::size_t n = 0; n <= kMaxVDegree; ++n) {
      of[n][0] = 1;
      for (std::size_t k = 1; k <= n; ++k) of[n][k] = of[n - 1][k - 1] + of[n - 1][k];
    }
  }
};
constexpr LaneBinomials kBinomials;

#if defined(__x86_64__)

namespace avx2 {
#define VT_TARGET __attribute__((target("avx2")))
constexpr std::size_t kLanes = 4;
typedef double Lanes __attribute__((vector_size(32)));
VT_TARGET static inline Lanes load(const double* p) { return _mm256_loadu_pd(p); }
VT_TARGET static inline void store(double* p, Lanes a) { _mm256_storeu_pd(p, a); }
VT_TARGET static inline Lanes all(double x) { return _mm256_set1_pd(x); }
VT_TARGET static inline Lanes root(Lanes a) { return _mm256_sqrt_pd(a); }
VT_TARGET static inline Lanes smaller(Lanes a, Lanes b) { return _mm256_min_pd(a, b); }
VT_TARGET static inline Lanes larger(Lanes a, Lanes b) { return _mm256_max_pd(a, b); }
VT_TARGET static inline Lanes magnitude(Lanes a) {
  return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
}
VT_TARGET static inline Lanes gather(const double* x, const std::uint32_t* at) {
  return _mm256_setr_pd(x[at[0]], x[at[1]], x[at[2]], x[at[3]]);
}
struct Mask {
  Lanes bits;
  VT_TARGET friend inline Mask operator&(const Mask& a, const Mask& b) {
    return {_mm256_and_pd(a.bits, b.bits)};
  }
};
VT_TARGET static inline Mask less(Lanes a, Lanes b) { return {_mm256_cmp_pd(a, b, _CMP_LT_OQ)}; }
VT_TARGET static inline Lanes choose(const Mask& mask, Lanes yes, Lanes no) {
  return _mm256_blendv_pd(no, yes, mask.bits);
}
#include "solids/micro/mesh/mesh_lanes.inc"
#undef VT_TARGET
}  // namespace avx2

namespace baseline {
#define VT_TARGET
constexpr std::size_t kLanes = 2;
typedef double Lanes __attribute__((vector_size(16)));
static inline Lanes load(const double* p) { return _mm_loadu_pd(p); }
static inline void store(double* p, Lanes a) { _mm_storeu_pd(p, a); }
static inline Lanes all(double x) { return _mm_set1_pd(x); }
static inline Lanes root(Lanes a) { return _mm_sqrt_pd(a); }
static inline Lanes smaller(Lanes a, Lanes b) { return _mm_min_pd(a, b); }
static inline Lanes larger(Lanes a, Lanes b) { return _mm_max_pd(a, b); }
static inline Lanes magnitude(Lanes a) { return _mm_andnot_pd(_mm_set1_pd(-0.0), a); }
static inline Lanes gather(const double* x, const std::uint32_t* at) {
  return _mm_setr_pd(x[at[0]], x[at[1]]);
}
struct Mask {
  Lanes bits;
  friend Mask operator&(const Mask& a, const Mask& b) { return {_mm_and_pd(a.bits, b.bits)}; }
};
static inline Mask less(Lanes a, Lanes b) { return {_mm_cmplt_pd(a, b)}; }
static inline Lanes choose(const Mask& mask, Lanes yes, Lanes no) {
  return _mm_or_pd(_mm_and_pd(mask.bits, yes), _mm_andnot_pd(mask.bits, no));
}
#include "solids/micro/mesh/mesh_lanes.inc"
#undef VT_TARGET
}  // namespace baseline

#else

namespace baseline {
#define VT_TARGET
constexpr std::size_t kLanes = 1;
using Lanes = double;
static inline Lanes load(const double* p) { return *p; }
static inline void store(double* p, Lanes a) { *p = a; }
static inline Lanes all(double x) { return x; }
static inline Lanes root(Lanes a) { return std::sqrt(a); }
static inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
static inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
static inline Lanes magnitude(Lanes a) { return std::abs(a); }
static inline Lanes gather(const double* x, const std::uint32_t* at) { return x[at[0]]; }
using Mask = bool;
static inline Mask less(Lanes a, Lanes b) { return a < b; }
static inline Lanes choose(Mask mask, Lanes yes, Lanes no) { return mask ? yes : no; }
#include "solids/micro/mesh/mesh_lanes.inc"
#undef VT_TARGET
}  // namespace baseline

#endif

bool has_wide_lanes() {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  return has_avx2 && !only_baseline_lanes.load(std::memory_order_relaxed);
#else
  return false;
#endif
}

bool is_uniform(const RoundedCell& map, std::size_t degree) {
  return map.size[0] == degree + 1 && map.size[1] == degree + 1 && map.size[2] == degree + 1;
}

}  // namespace

#if defined(__x86_64__)
#define VT_LANES(call) (has_wide_lanes() ? avx2::call : baseline::call)
#else
#define VT_LANES(call) baseline::call
#endif

void place_points(const PointTable& table, std::size_t begin, std::size_t end,
                  const WallParameters& t, PointColumns& out) {
  out.resize(end - begin);
  VT_LANES(place(table, begin, end, t, out));
}

void map_points(const RoundedCell& map, std::size_t n, PointColumns& points) {
  if (is_uniform(map, 1)) return VT_LANES(map_all<1>(map, n, points));
  if (is_uniform(map, 2)) return VT_LANES(map_all<2>(map, n, points));
  if (is_uniform(map, 3)) return VT_LANES(map_all<3>(map, n, points));
  VT_LANES(map_all<0>(map, n, points));
}

void quad_gaps(const PointColumns& points, const std::array<std::uint32_t, 4>* quads, std::size_t n,
               double* out) {
  VT_LANES(gaps(points, quads, n, out));
}

#undef VT_LANES

void use_baseline_lanes(bool only_baseline) {
  only_baseline_lanes.store(only_baseline, std::memory_order_relaxed);
}

}  // namespace veritope::internal
