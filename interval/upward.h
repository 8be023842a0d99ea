// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/upward.h: a scope in which this thread rounds upward, and the fences that keep
// operations inside it.
#pragma once
#if defined(__SSE2__)
#include <immintrin.h>
#else
#include <cfenv>
#endif

#include "robust/base/fp_state.h"

namespace veritope {

/// From construction to destruction this thread rounds binary64 operations upward, with gradual underflow and all
/// exceptions masked, whatever it did before: the control word is loaded as a whole, so that a caller's FTZ or DAZ is
/// off, too. The destructor restores the caller's word. Filters of predicates rely on rounding to nearest and
/// therefore decide nothing inside; the predicates still answer.
/// Only operands and results that pass through fenced() are known to be computed inside.
class ScopedUpward {
 public:
  ScopedUpward(const ScopedUpward&) = delete;
  ScopedUpward& operator=(const ScopedUpward&) = delete;
#if defined(__SSE2__)
  ScopedUpward() : saved_(_mm_getcsr()) { load(0x1f80u | _MM_ROUND_UP); }
  ~ScopedUpward() { load(saved_); }

 private:
  // An asm volatile, like fenced(): the compiler keeps the order of volatile asm statements.
  static void load(unsigned word) { asm volatile("ldmxcsr %0" : : "m"(word) : "memory"); }
  internal::ScopedNoFilters no_filters_;
  unsigned saved_;
#else
  ScopedUpward() {
    std::fegetenv(&saved_);
    std::fesetenv(FE_DFL_ENV);
    std::fesetround(FE_UPWARD);
  }
  ~ScopedUpward() { std::fesetenv(&saved_); }

 private:
  internal::ScopedNoFilters no_filters_;
  std::fenv_t saved_;
#endif
};

/// Returns the value, but the compiler may neither know it nor move its uses before, nor its
/// computation after, this point relative to a ScopedUpward's ends: no constant folding and no
/// hoisting into another rounding mode.
[[gnu::always_inline]] inline double fenced(double v) {
#if defined(__SSE2__)
  asm volatile("" : "+x"(v));
#elif defined(__aarch64__)
  asm volatile("" : "+w"(v));
#else
  asm volatile("" : "+m"(v) : : "memory");
#endif
  return v;
}

}  // namespace veritope
