// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/work_share.h"

#include <gtest/gtest.h>

#include "robust/base/parallel.h"

namespace veritope {
namespace {

TEST(WorkShare, NothingIsKnownBetweenSteps) {
  WorkShare work;
  EXPECT_EQ(work.view().percent(), std::nullopt);
  {
    WorkStep step(&work, 4);
    EXPECT_EQ(work.view().percent(), 0);
    step.add(1);
    EXPECT_EQ(work.view().percent(), 25);
    EXPECT_EQ(work.view().step, 1U);
  }
  EXPECT_EQ(work.view().percent(), std::nullopt);
  EXPECT_EQ(work.view().done, 1);
  EXPECT_EQ(work.view().whole, 4);
  WorkStep next(&work, 3);
  EXPECT_EQ(work.view().step, 2U);
  EXPECT_EQ(work.view().percent(), 0);
  work.reset();
  EXPECT_EQ(work.view().percent(), std::nullopt);
  WorkStep first(&work, 3);
  EXPECT_EQ(work.view().step, 1U);
}

TEST(WorkShare, AStepThatStillRunsIsNeverComplete) {
  WorkShare work;
  WorkStep step(&work, 3);
  int last = 0;
  for (int i = 0; i < 1000; ++i) {
    step.add(0.0031);
    const int now = work.view().percent().value();
    EXPECT_LE(last, now);
    EXPECT_LE(now, 99);
    last = now;
  }
  EXPECT_EQ(last, 99);
}

TEST(WorkShare, AnAmountOfZeroHasNoShare) {
  WorkShare work;
  WorkStep step(&work, 0);
  EXPECT_EQ(work.view().percent(), std::nullopt);
  WorkStep none(nullptr, 1);
  none.add(1);
}

TEST(WorkShare, PartsOfAllThreadsCount) {
  WorkShare work;
  WorkStep step(&work, 4000);
  parallel_for(2000, 1, 4, [&](std::size_t, std::size_t, std::size_t) { step.add(1); });
  EXPECT_EQ(work.view().done, 2000);
  EXPECT_EQ(work.view().percent(), 50);
}

}  // namespace
}  // namespace veritope
