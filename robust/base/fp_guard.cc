// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/fp_guard.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "robust/base/fp_probe.h"

namespace veritope {

const char* fp_problem_name(FpProblem problem) {
  switch (problem) {
    case FpProblem::kRoundingMode: return "rounding-mode";
    case FpProblem::kFlushToZero: return "flush-to-zero";
    case FpProblem::kDenormalsAreZero: return "denormals-are-zero";
    case FpProblem::kContraction: return "contraction";
    case FpProblem::kExcessPrecision: return "excess-precision";
    case FpProblem::kReassociation: return "reassociation";
  }
  return "unknown";
}

const char* fp_problem_advice(FpProblem problem) {
  switch (problem) {
    case FpProblem::kRoundingMode:
      return "the thread does not round to nearest: restore it with fesetround(FE_TONEAREST)";
    case FpProblem::kFlushToZero:
      return "small results are flushed to zero: a library built with -ffast-math may have set FTZ";
    case FpProblem::kDenormalsAreZero:
      return "small operands count as zero: a library built with -ffast-math may have set DAZ";
    case FpProblem::kContraction:
      return "products and sums are fused: compile with -ffp-contract=off";
    case FpProblem::kExcessPrecision:
      return "binary64 has excess precision: compile for SSE2, not x87";
    case FpProblem::kReassociation:
      return "sums are reordered: compile without -ffast-math and -fassociative-math";
  }
  return "unknown";
}

std::vector<FpProblem> probe_fp() {
  std::vector<FpProblem> found;
  const unsigned bits = internal::probe_fp_here();
  for (unsigned i = 0; i < 6; ++i) {
    if ((bits >> i & 1) != 0) found.push_back(static_cast<FpProblem>(i));
  }
  return found;
}

Status check_fp() {
  std::string text;
  for (const FpProblem p : probe_fp()) {
    text += text.empty() ? "floating point is not as the predicates need it: " : "; ";
    text += std::string(fp_problem_name(p)) + " (" + fp_problem_advice(p) + ")";
  }
  if (text.empty()) return ok_status();
  return Error{Code::kBadEnvironment, {}, text};
}

#if defined(__SSE2__)
ScopedDefaultFp::ScopedDefaultFp() : saved_(_mm_getcsr()) { _mm_setcsr(0x1f80u); }
ScopedDefaultFp::~ScopedDefaultFp() { _mm_setcsr(saved_); }
#else
ScopedDefaultFp::ScopedDefaultFp() {
  std::fegetenv(&saved_);
  std::fesetenv(FE_DFL_ENV);
}
ScopedDefaultFp::~ScopedDefaultFp() { std::fesetenv(&saved_); }
#endif

}  // namespace veritope
