// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/fp_guard.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "robust/base/fp_probe.h"

namespace veritope {

namespace internal {

constinit thread_local double fp_floor __attribute__((tls_model("initial-exec"))) =
    std::numeric_limits<double>::infinity();
constinit thread_local bool fp_is_probed __attribute__((tls_model("initial-exec"))) = false;

namespace {
constexpr std::uint64_t kInfinityBits = 0x7ff0000000000000u;
// A fused product omits one rounding: it does no harm where it is not prevented (robust/filter.h).
constexpr unsigned kHarmless = 1u << static_cast<unsigned>(FpProblem::kContraction);
}  // namespace

bool probe_filters() noexcept {
  refresh_fp();
  return filters_are_sound();
}

// The floor is copied by its bits: a build that may not know infinities still stores one.
FpState forget_fp() noexcept {
  FpState state;
  std::memcpy(&state.floor, &fp_floor, sizeof fp_floor);
  state.is_probed = fp_is_probed;
  std::memcpy(&fp_floor, &kInfinityBits, sizeof fp_floor);
  fp_is_probed = false;
  return state;
}
void restore_fp(FpState state) noexcept {
  std::memcpy(&fp_floor, &state.floor, sizeof fp_floor);
  fp_is_probed = state.is_probed;
}

}  // namespace internal

namespace {

// The probe overflows on purpose: with traps it would end the program. In a thread with traps no filter's
// answer counts; it is still computed, and traps where it overflows.
bool probe_says_sound() noexcept {
#if defined(__SSE2__)
  constexpr unsigned kMasks = 0x1f80u;
  const unsigned word = _mm_getcsr();
  _mm_setcsr(word | kMasks);
  const unsigned problems = internal::probe_fp_here();
  _mm_setcsr(word);
  const bool has_traps = (word & kMasks) != kMasks;
#else
  std::fenv_t environment;
  std::feholdexcept(&environment);
  const unsigned problems = internal::probe_fp_here();
  std::fesetenv(&environment);
  constexpr bool has_traps = false;
#endif
  return !has_traps && (problems & ~internal::kHarmless) == 0;
}

}  // namespace

void refresh_fp() noexcept {
  const bool is_sound = probe_says_sound();
  constexpr std::uint64_t kFloorBits = std::bit_cast<std::uint64_t>(kFilterFloor);
  const std::uint64_t bits = is_sound && kFiltersAreCompiled ? kFloorBits : internal::kInfinityBits;
  std::memcpy(&internal::fp_floor, &bits, sizeof bits);
  internal::fp_is_probed = true;
}

bool filters_are_sound() noexcept {
  if (!internal::fp_is_probed) refresh_fp();
  std::uint64_t bits;
  std::memcpy(&bits, &internal::fp_floor, sizeof bits);
  return bits != internal::kInfinityBits;
}

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
    text += text.empty() ? "floating point is not as the filters need it: " : "; ";
    text += std::string(fp_problem_name(p)) + " (" + fp_problem_advice(p) + ")";
  }
  if (text.empty()) return ok_status();
  return Error{Code::kBadEnvironment, {}, text};
}

#if defined(__SSE2__)
ScopedDefaultFp::ScopedDefaultFp() : outside_(internal::forget_fp()), saved_(_mm_getcsr()) {
  _mm_setcsr(0x1f80u);
}
ScopedDefaultFp::~ScopedDefaultFp() {
  _mm_setcsr(saved_);
  internal::restore_fp(outside_);
}
#else
ScopedDefaultFp::ScopedDefaultFp() : outside_(internal::forget_fp()) {
  std::fegetenv(&saved_);
  std::fesetenv(FE_DFL_ENV);
}
ScopedDefaultFp::~ScopedDefaultFp() {
  std::fesetenv(&saved_);
  internal::restore_fp(outside_);
}
#endif

}  // namespace veritope
