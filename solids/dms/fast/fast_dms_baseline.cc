// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_dms_baseline.cc: what every processor has; two vectors of two lanes with SSE2.
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "solids/dms/fast/fast_dms_loops_internal.h"

namespace veritope::internal {
namespace {

#if defined(__SSE2__)
struct DmsHalf {
  __m128d v;
  static DmsHalf load(const double* p) { return {_mm_loadu_pd(p)}; }
  static void store(double* p, DmsHalf a) { _mm_storeu_pd(p, a.v); }
  static DmsHalf all(double x) { return {_mm_set1_pd(x)}; }
  static DmsHalf two(double a, double b) { return {_mm_set_pd(b, a)}; }
  friend DmsHalf operator+(DmsHalf a, DmsHalf b) { return {_mm_add_pd(a.v, b.v)}; }
  friend DmsHalf operator-(DmsHalf a, DmsHalf b) { return {_mm_sub_pd(a.v, b.v)}; }
  friend DmsHalf operator*(DmsHalf a, DmsHalf b) { return {_mm_mul_pd(a.v, b.v)}; }
  static DmsHalf min(DmsHalf a, DmsHalf b) { return {_mm_min_pd(a.v, b.v)}; }
  static DmsHalf max(DmsHalf a, DmsHalf b) { return {_mm_max_pd(a.v, b.v)}; }
  static DmsHalf abs(DmsHalf a) { return {_mm_andnot_pd(_mm_set1_pd(-0.0), a.v)}; }
  static DmsHalf less(DmsHalf a, DmsHalf b) { return {_mm_cmplt_pd(a.v, b.v)}; }
  static DmsHalf without(DmsHalf a, DmsHalf mask) { return {_mm_andnot_pd(mask.v, a.v)}; }
  static DmsHalf either(DmsHalf a, DmsHalf b) { return {_mm_or_pd(a.v, b.v)}; }
  static unsigned bits(DmsHalf mask) { return static_cast<unsigned>(_mm_movemask_pd(mask.v)); }
};
#else
// A mask is 1 where it holds, else 0.
struct DmsHalf {
  double v[2];
  template <typename F>
  static DmsHalf each(DmsHalf a, DmsHalf b, F f) {
    return {{f(a.v[0], b.v[0]), f(a.v[1], b.v[1])}};
  }
  static DmsHalf load(const double* p) { return {{p[0], p[1]}}; }
  static void store(double* p, DmsHalf a) { p[0] = a.v[0], p[1] = a.v[1]; }
  static DmsHalf all(double x) { return {{x, x}}; }
  static DmsHalf two(double a, double b) { return {{a, b}}; }
  friend DmsHalf operator+(DmsHalf a, DmsHalf b) {
    return each(a, b, [](double x, double y) { return x + y; });
  }
  friend DmsHalf operator-(DmsHalf a, DmsHalf b) {
    return each(a, b, [](double x, double y) { return x - y; });
  }
  friend DmsHalf operator*(DmsHalf a, DmsHalf b) {
    return each(a, b, [](double x, double y) { return x * y; });
  }
  static DmsHalf min(DmsHalf a, DmsHalf b) {
    return each(a, b, [](double x, double y) { return x < y ? x : y; });
  }
  static DmsHalf max(DmsHalf a, DmsHalf b) {
    return each(a, b, [](double x, double y) { return x > y ? x : y; });
  }
  static DmsHalf abs(DmsHalf a) { return {{__builtin_fabs(a.v[0]), __builtin_fabs(a.v[1])}}; }
  static DmsHalf less(DmsHalf a, DmsHalf b) {
    return each(a, b, [](double x, double y) { return x < y ? 1.0 : 0.0; });
  }
  static DmsHalf without(DmsHalf a, DmsHalf mask) {
    return each(a, mask, [](double x, double m) { return m != 0 ? 0.0 : x; });
  }
  static DmsHalf either(DmsHalf a, DmsHalf b) {
    return each(a, b, [](double x, double y) { return x != 0 || y != 0 ? 1.0 : 0.0; });
  }
  static unsigned bits(DmsHalf mask) {
    return (mask.v[0] != 0 ? 1u : 0u) | (mask.v[1] != 0 ? 2u : 0u);
  }
};
#endif

struct DmsLanes22 {
  DmsHalf lo, hi;
  using Self = DmsLanes22;
  static Self load(const double* p) { return {DmsHalf::load(p), DmsHalf::load(p + 2)}; }
  static void store(double* p, Self a) { DmsHalf::store(p, a.lo), DmsHalf::store(p + 2, a.hi); }
  static Self all(double x) { return {DmsHalf::all(x), DmsHalf::all(x)}; }
  static Self four(double a, double b, double c, double d) {
    return {DmsHalf::two(a, b), DmsHalf::two(c, d)};
  }
  friend Self operator+(Self a, Self b) { return {a.lo + b.lo, a.hi + b.hi}; }
  friend Self operator-(Self a, Self b) { return {a.lo - b.lo, a.hi - b.hi}; }
  friend Self operator*(Self a, Self b) { return {a.lo * b.lo, a.hi * b.hi}; }
  static Self min(Self a, Self b) { return {DmsHalf::min(a.lo, b.lo), DmsHalf::min(a.hi, b.hi)}; }
  static Self max(Self a, Self b) { return {DmsHalf::max(a.lo, b.lo), DmsHalf::max(a.hi, b.hi)}; }
  static Self abs(Self a) { return {DmsHalf::abs(a.lo), DmsHalf::abs(a.hi)}; }
  static Self less(Self a, Self b) {
    return {DmsHalf::less(a.lo, b.lo), DmsHalf::less(a.hi, b.hi)};
  }
  static Self without(Self a, Self mask) {
    return {DmsHalf::without(a.lo, mask.lo), DmsHalf::without(a.hi, mask.hi)};
  }
  static Self either(Self a, Self b) {
    return {DmsHalf::either(a.lo, b.lo), DmsHalf::either(a.hi, b.hi)};
  }
  static unsigned bits(Self mask) { return DmsHalf::bits(mask.lo) | DmsHalf::bits(mask.hi) << 2; }
  static bool any(Self mask) { return bits(mask) != 0; }
  static bool lane(Self mask, std::size_t l) { return ((bits(mask) >> l) & 1) != 0; }
};

}  // namespace

constexpr FastDmsKernels kFastDmsBaseline = fast_dms_kernels_of<DmsLanes22>();

}  // namespace veritope::internal
