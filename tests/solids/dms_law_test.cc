// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_law_test.cc: the laws of simplex-spline solids, exactly, at points on faces, edges, vertices, knots
// and planes of knots too. The experiment soak_dms_laws runs them on more models.
#include <gtest/gtest.h>

#include "solids/dms/dms_evaluator.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/dms_laws.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

TEST(DmsLaws, HoldAtRandomPointsOfRandomModels) {
  DmsLawCounts counts;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(150)); ++seed) {
    const std::string broken = check_dms_laws(seed, 5, 12, counts);
    ASSERT_EQ(broken, "");
  }
  EXPECT_GE(counts.pairs, 1500u);
  EXPECT_GE(counts.special, counts.pairs / 4);
}

}  // namespace
}  // namespace veritope
