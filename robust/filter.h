// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/filter.h: what a rounded value says about the exact one.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "robust/base/fp_state.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"

VT_PRECISE_BEGIN
namespace veritope {

/// The number type of filters: double, or, where the compiler might fuse products and sums, one whose
/// results it may not look into. (A fused operation rounds once instead of twice, which the bounds
/// allow; but it may overflow where the terms of the bound do not.)
#if VT_MAY_CONTRACT
struct FilterReal {
  double v = 0;
  constexpr FilterReal() = default;
  constexpr FilterReal(double value) : v(value) {}
  constexpr operator double() const { return v; }
  [[gnu::always_inline]] static FilterReal opaque(double v) {
#if defined(__SSE2__)
    asm("" : "+x"(v));
#elif defined(__aarch64__)
    asm("" : "+w"(v));
#else
    asm("" : "+m"(v));
#endif
    return v;
  }
  friend FilterReal operator-(FilterReal a) { return -a.v; }
  friend FilterReal operator+(FilterReal a, FilterReal b) { return opaque(a.v + b.v); }
  friend FilterReal operator-(FilterReal a, FilterReal b) { return opaque(a.v - b.v); }
  friend FilterReal operator*(FilterReal a, FilterReal b) { return opaque(a.v * b.v); }
  friend FilterReal operator+(double a, FilterReal b) { return opaque(a + b.v); }
  friend FilterReal operator-(double a, FilterReal b) { return opaque(a - b.v); }
  friend FilterReal operator*(double a, FilterReal b) { return opaque(a * b.v); }
  friend FilterReal operator+(FilterReal a, double b) { return opaque(a.v + b); }
  friend FilterReal operator-(FilterReal a, double b) { return opaque(a.v - b); }
  friend FilterReal operator*(FilterReal a, double b) { return opaque(a.v * b); }
};
#else
using FilterReal = double;
#endif

/// The sign of `value` if it is farther from zero than bound(floor), otherwise uncertain; never zero. If the error of
/// value is at most bound(kFilterFloor), a certain answer is the sign of the exact value. A NaN on either side, or an
/// infinite bound, gives uncertain: overflow decides nothing. The floor is infinite, and every answer uncertain, in a
/// thread whose floating point is not as the bounds assume; in a translation unit of that kind every answer is
/// uncertain, too.
/// There is no branch on the sign itself, which is as good as random where it matters: a mispredicted branch costs more
/// than the predicate (bench/bench_predicates.cc).
/// REQUIRES bound(floor) >= 0 or NaN, at least the floor.
template <typename Bound>
requires std::is_invocable_r_v<double, Bound, double>
[[gnu::always_inline]] inline Sign3 sign_beyond(double value, Bound bound) {
  if constexpr (!kFiltersAreCompiled) return Sign3::kUncertain;
  const auto compared = [&]() __attribute__((always_inline)) {
    const double b = bound(internal::fp_floor);
    // 1 or -1 from the sign bit.
    const auto sign = static_cast<int>(std::bit_cast<std::int64_t>(value) >> 63) | 1;
    return std::abs(value) > b ? static_cast<Sign3>(sign) : Sign3::kUncertain;
  };
  const Sign3 s = compared();
  if (is_certain(s)) [[likely]]
    return s;
  if (internal::fp_is_probed) [[likely]]
    return s;
  return internal::probe_filters() ? compared() : s;
}
/// Like the function above, with the bound `bound` + floor.
[[gnu::always_inline]] inline Sign3 sign_beyond(double value, double bound) {
  return sign_beyond(value, [bound](double floor) { return bound + floor; });
}

/// The larger number, without a branch: for `>` compilers sometimes emit one.
/// REQUIRES no NaN.
[[gnu::always_inline]] inline double larger(double v, double w) {
#if defined(__SSE2__)
  return _mm_cvtsd_f64(_mm_max_sd(_mm_set_sd(v), _mm_set_sd(w)));
#else
  return v > w ? v : w;
#endif
}

}  // namespace veritope
VT_PRECISE_END
