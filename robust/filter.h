// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/filter.h: what a rounded value says about the exact one.
#pragma once
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"

namespace veritope {

/// The sign of `value` if it is farther from zero than `bound`, else uncertain; never zero. If the
/// error of value is at most bound, a certain answer is the sign of the exact value. A NaN on
/// either side, or an infinite bound, is uncertain: overflow is no answer.
/// No branch on the sign itself, which is as good as random where it matters: a mispredicted branch
/// costs more than the predicate (bench/bench_predicates.cc).
/// REQUIRES bound >= 0 or NaN.
[[gnu::always_inline]] constexpr Sign3 sign_beyond(double value, double bound) {
  const int sign = static_cast<int>(value > bound) - static_cast<int>(-value > bound);
  return sign != 0 ? static_cast<Sign3>(sign) : Sign3::kUncertain;
}

/// The larger one, without a branch: compilers make one of `>` where they think they know better.
/// REQUIRES no NaN.
[[gnu::always_inline]] inline double larger(double v, double w) {
#if defined(__SSE2__)
  return _mm_cvtsd_f64(_mm_max_sd(_mm_set_sd(v), _mm_set_sd(w)));
#else
  return v > w ? v : w;
#endif
}

}  // namespace veritope
