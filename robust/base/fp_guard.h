// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/fp_guard.h: does this thread, in this build, compute as the filters' bounds assume? The first filter of a
// thread asks this; if the answer is no, filters are uncertain and integers decide. fp_strict.h handles what the
// compiler's macros show.
#pragma once
#include <string>
#include <vector>
#if !defined(__SSE2__)
#include <cfenv>
#endif

#include "robust/base/fp_state.h"
#include "robust/base/fp_strict.h"
#include "robust/base/result.h"

namespace veritope {

/// One way in which binary64 arithmetic can differ from IEEE 754 round-to-nearest, one operation at
/// a time.
enum class FpProblem {
  kRoundingMode,  ///< not to nearest: another library left its own mode
  kFlushToZero,  ///< FTZ: subnormal results become 0 (a library built with -ffast-math can switch it on)
  kDenormalsAreZero,  ///< DAZ: subnormal operands count as 0
  kContraction,       ///< a * b + c is computed with one rounding: compile with -ffp-contract=off
  kExcessPrecision,   ///< results have more bits or a larger range than binary64: x87
  kReassociation,     ///< sums are computed in another order: -ffast-math, -fassociative-math
};

/// "rounding-mode", with what to do about it in fp_problem_advice.
const char* fp_problem_name(FpProblem problem);
const char* fp_problem_advice(FpProblem problem);

/// What is wrong in the calling thread, found by computing. `probe_fp` judges the library's own
/// build; `internal::probe_fp_here`, from fp_probe.h, the translation unit that calls it.
std::vector<FpProblem> probe_fp();

/// Success, or kBadEnvironment with one sentence that names every problem and its remedy.
Status check_fp();

/// From construction to destruction this thread has the default environment: to nearest, no FTZ, no
/// DAZ, exceptions masked. The whole control word is set, and the caller's is restored; filters may
/// decide inside, and outside as before.
class ScopedDefaultFp {
 public:
  ScopedDefaultFp();
  ~ScopedDefaultFp();
  ScopedDefaultFp(const ScopedDefaultFp&) = delete;
  ScopedDefaultFp& operator=(const ScopedDefaultFp&) = delete;

 private:
  internal::FpState outside_;
#if defined(__SSE2__)
  unsigned saved_;
#else
  std::fenv_t saved_;
#endif
};

}  // namespace veritope
