// SPDX-License-Identifier: LGPL-3.0-or-later
// certify on simplex-spline solids whose verdict is known by construction; ./dev soak dms_truth has more of them.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "tests/support/dms_truth_judge.h"

namespace veritope {
namespace {

void expect_right(const char* name, std::uint64_t count) {
  for (const dms_truth::Class& kind : dms_truth::classes()) {
    if (std::string(kind.name) != name) continue;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
      const dms_truth::Case drawn = kind.draw(seed);
      const Certified said = dms_truth::certified(drawn.model);
      EXPECT_EQ(dms_truth::judge(drawn, said), dms_truth::Judgement::kRight)
          << drawn.text << ": " << dms_truth::said_of(said);
    }
  }
}

TEST(DmsTruth, DisplacementsBelowTheMarginAreValid) { expect_right("displaced", 5); }
TEST(DmsTruth, NegativeDeterminantsAreFound) {
  expect_right("dragged", 20);
  expect_right("folded", 5);
}
TEST(DmsTruth, ADeterminantThatIsZeroAtOnePointIsNotInvalid) { expect_right("fold_twins", 1); }
TEST(DmsTruth, BarsThatMeetThemselvesAreInvalid) {
  expect_right("bent", 3);
  expect_right("bent_twins", 2);
}
TEST(DmsTruth, WoundWedgesAreInvalid) {
  expect_right("wound", 20);
  expect_right("wound_twins", 2);
}
TEST(DmsTruth, BodiesInsideOfTheImagesOfOthersAreInvalid) {
  expect_right("nested", 20);
  expect_right("nested_twins", 3);
}
TEST(DmsTruth, CloudsAtTheLimitsAreDecided) {
  expect_right("clouds", 20);
  expect_right("cloud_twins", 3);
}

}  // namespace
}  // namespace veritope
