// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/fp_guard.h"

#include <gtest/gtest.h>
#include <immintrin.h>

#include <algorithm>
#include <cfenv>

#include "robust/base/fp_probe.h"

namespace veritope {
namespace {

bool found(FpProblem problem) {
  const std::vector<FpProblem> all = probe_fp();
  return std::find(all.begin(), all.end(), problem) != all.end();
}

TEST(FpGuard, FindsNothingWrongInThisBuild) {
  EXPECT_TRUE(probe_fp().empty());
  EXPECT_TRUE(check_fp().has_value());
  EXPECT_EQ(internal::probe_fp_here(), 0u);
}

TEST(FpGuard, FindsEveryOtherRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::vector<FpProblem> all = probe_fp();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(all, std::vector<FpProblem>{FpProblem::kRoundingMode}) << mode;
  }
}

TEST(FpGuard, FindsFlushToZeroAndDenormalsAreZero) {
  const unsigned saved = _mm_getcsr();
  _mm_setcsr(saved | 0x8000u);
  const bool ftz = found(FpProblem::kFlushToZero), daz_too = found(FpProblem::kDenormalsAreZero);
  _mm_setcsr(saved | 0x0040u);
  const bool daz = found(FpProblem::kDenormalsAreZero), ftz_too = found(FpProblem::kFlushToZero);
  _mm_setcsr(saved);
  EXPECT_TRUE(ftz && daz);
  EXPECT_FALSE(ftz_too || daz_too);
}

TEST(FpGuard, NamesEachProblemWithItsRemedy) {
  std::fesetround(FE_UPWARD);
  const Status status = check_fp();
  std::fesetround(FE_TONEAREST);
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().code, Code::kBadEnvironment);
  EXPECT_NE(status.error().message.find("rounding-mode (the thread does not round to nearest"),
            std::string::npos);
  for (int i = 0; i < 6; ++i) {
    EXPECT_STRNE(fp_problem_name(static_cast<FpProblem>(i)), "unknown");
    EXPECT_STRNE(fp_problem_advice(static_cast<FpProblem>(i)), "unknown");
  }
  EXPECT_STREQ(fp_problem_name(static_cast<FpProblem>(99)), "unknown");
  EXPECT_STREQ(fp_problem_advice(static_cast<FpProblem>(99)), "unknown");
}

TEST(ScopedDefaultFp, FiltersMayDecideInsideAndOutsideAsBefore) {
  std::fesetround(FE_UPWARD);
  refresh_fp();
  const bool before = filters_are_sound();
  bool inside;
  {
    const ScopedDefaultFp guard;
    inside = filters_are_sound();
  }
  const bool after = filters_are_sound();
  std::fesetround(FE_TONEAREST);
  const bool unnoticed = filters_are_sound();
  refresh_fp();
  EXPECT_TRUE(!before && inside && !after && !unnoticed && filters_are_sound());
}

TEST(ScopedDefaultFp, GivesTheDefaultsAndRestoresTheCallersWord) {
  const unsigned saved = _mm_getcsr();
  _mm_setcsr(saved | 0xe040u);  // toward zero, FTZ, DAZ
  {
    const ScopedDefaultFp guard;
    EXPECT_TRUE(probe_fp().empty());
  }
  const unsigned restored = _mm_getcsr();
  _mm_setcsr(saved);
  EXPECT_EQ(restored & 0xe040u, 0xe040u);
}

}  // namespace
}  // namespace veritope
