// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline_baseline.cc: what every processor has; two vectors of two lanes with SSE2.
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "splines/fast_spline_loops_internal.h"

namespace veritope::internal {
namespace {

#if defined(__SSE2__)
using Half = __m128d;
inline Half half_load(const double* p) { return _mm_loadu_pd(p); }
inline void half_store(double* p, Half a) { _mm_storeu_pd(p, a); }
inline Half half_all(double x) { return _mm_set1_pd(x); }
inline Half half_minus(Half a) { return _mm_xor_pd(a, _mm_set1_pd(-0.0)); }
inline double half_first(Half a) { return _mm_cvtsd_f64(a); }
#else
struct Half {
  double a, b;
  friend Half operator+(Half x, Half y) { return {x.a + y.a, x.b + y.b}; }
  friend Half operator-(Half x, Half y) { return {x.a - y.a, x.b - y.b}; }
  friend Half operator*(Half x, Half y) { return {x.a * y.a, x.b * y.b}; }
};
inline Half half_load(const double* p) { return {p[0], p[1]}; }
inline void half_store(double* p, Half a) { p[0] = a.a, p[1] = a.b; }
inline Half half_all(double x) { return {x, x}; }
inline Half half_minus(Half a) { return {-a.a, -a.b}; }
inline double half_first(Half a) { return a.a; }
#endif

struct Lanes22 {
  Half lo, hi;
  [[gnu::always_inline]] static Lanes22 load(const double* p) {
    return {half_load(p), half_load(p + 2)};
  }
  [[gnu::always_inline]] static Lanes22 load_loose(const double* p) { return load(p); }
  [[gnu::always_inline]] static void store(double* p, Lanes22 a) {
    half_store(p, a.lo), half_store(p + 2, a.hi);
  }
  [[gnu::always_inline]] static void store3(double* p, Lanes22 a) {
    half_store(p, a.lo), p[2] = half_first(a.hi);
  }
  [[gnu::always_inline]] static Lanes22 all(double x) { return {half_all(x), half_all(x)}; }
  friend Lanes22 operator+(Lanes22 a, Lanes22 b) { return {a.lo + b.lo, a.hi + b.hi}; }
  friend Lanes22 operator-(Lanes22 a, Lanes22 b) { return {a.lo - b.lo, a.hi - b.hi}; }
  friend Lanes22 operator*(Lanes22 a, Lanes22 b) { return {a.lo * b.lo, a.hi * b.hi}; }
  friend Lanes22 operator-(Lanes22 a) { return {half_minus(a.lo), half_minus(a.hi)}; }
};

}  // namespace

constexpr FastKernels kFastBaseline = fast_kernels_of<Lanes22>();

}  // namespace veritope::internal
