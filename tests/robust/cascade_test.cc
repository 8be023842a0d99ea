// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/cascade.h"

#include <gtest/gtest.h>

namespace veritope {
namespace {

// With VT_AUDIT further ones are asked: see audit/audited_cascade.cc.
#if !defined(VT_AUDIT)
TEST(Cascade, TakesTheFirstCertainAnswerAndAsksNoFurther) {
  int asked = 0;
  const auto tier = [&](Sign3 answer) { return [&asked, answer] { return ++asked, answer; }; };
  const auto last = [&] { return ++asked, Sign::kNegative; };
  TierCounts tally;
  EXPECT_EQ(cascade(&tally, tier(Sign3::kPositive), tier(Sign3::kNegative), last), Sign::kPositive);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(cascade(&tally, tier(Sign3::kUncertain), tier(Sign3::kZero), last), Sign::kZero);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(cascade(&tally, tier(Sign3::kUncertain), tier(Sign3::kUncertain), last),
            Sign::kNegative);
  EXPECT_EQ(asked, 6);
  EXPECT_EQ(tally, (TierCounts{{1, 1, 1, 0}}));
}

TEST(Cascade, NeedsNoTally) {
  EXPECT_EQ(cascade(
                nullptr, [] { return Sign3::kUncertain; }, [] { return Sign::kZero; }),
            Sign::kZero);
  EXPECT_EQ(cascade(
                nullptr, [] { return Sign3::kPositive; }, [] { return Sign::kZero; }),
            Sign::kPositive);
}
#endif

TEST(Cascade, GoesOnInAnotherCascadeThatKeepsTheTally) {
  TierCounts tally;
  const auto rest = [](TierCounts* t) {
    return cascade<1>(
        t, [] { return Sign3::kUncertain; }, [] { return Sign3::kUncertain; },
        [] { return Sign::kPositive; });
  };
  EXPECT_EQ(cascade(
                &tally, [] { return Sign3::kUncertain; }, rest),
            Sign::kPositive);
  EXPECT_EQ(tally[Tier::kExact], 1u);
  EXPECT_EQ(tally, (TierCounts{{0, 0, 0, 1}}));
}

TEST(Cascade, IsUsableAtCompileTime) {
  static_assert(cascade(
                    nullptr, [] { return Sign3::kUncertain; }, [] { return Sign::kNegative; }) ==
                Sign::kNegative);
}

TEST(TierCounts, AddUp) {
  TierCounts a{{1, 2, 3, 4}};
  a += TierCounts{{10, 20, 30, 40}};
  EXPECT_EQ(a, (TierCounts{{11, 22, 33, 44}}));
}

}  // namespace
}  // namespace veritope
