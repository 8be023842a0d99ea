// SPDX-License-Identifier: LGPL-3.0-or-later
// The C++ checker's limit on the memory of a descent: what a descent holds besides nodes counts, too.
#include <gtest/gtest.h>

#include "verify/checker/patches/star_forest.h"

namespace {

constexpr std::uint64_t kMostLimbs = std::uint64_t{160} << 20;  // the page's 1,280 MiB

struct EmptyForest {
  StarBody body;
  Units units{0, 1, "C2"};
  Forest forest{&body, &units};
};

TEST(CheckerForest, RejectsADescentThatHoldsMoreThanTheLimit) {
  EmptyForest f;
  EXPECT_NO_THROW((Forest::Held{&f.forest, kMostLimbs - kNodeLimbs}));
  EmptyForest g;
  EXPECT_THROW((Forest::Held{&g.forest, kMostLimbs}), Rejected);
}

// Each level of a descent holds its own part.
TEST(CheckerForest, AddsUpWhatAllLevelsHold) {
  EmptyForest f;
  const Forest::Held first(&f.forest, kMostLimbs / 2);
  const Forest::Held second(&f.forest, kMostLimbs / 4);
  try {
    const Forest::Held third(&f.forest, kMostLimbs / 4);
    FAIL() << "three parts of the limit and what they cost themselves were accepted";
  } catch (const Rejected& why) {
    EXPECT_EQ(why.id, "C2");
  }
}

TEST(CheckerForest, CountsNothingThatIsNoLongerHeld) {
  EmptyForest f;
  for (int i = 0; i < 100; ++i) EXPECT_NO_THROW((Forest::Held{&f.forest, kMostLimbs - kNodeLimbs}));
}

}  // namespace
