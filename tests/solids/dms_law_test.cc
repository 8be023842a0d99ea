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

void expect_laws(std::uint64_t first, long models, int degree) {
  DmsLawCounts counts;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(scaled(models)); ++i)
    ASSERT_EQ(check_dms_laws(first + i, degree, 12, counts), "");
  EXPECT_EQ(counts.pairs, 12 * counts.models);
  EXPECT_GE(counts.special, counts.pairs / 4);
  EXPECT_GE(counts.on_knots, counts.pairs / 4);
}

TEST(DmsLaws, HoldAtRandomPointsOfRandomModels) { expect_laws(1, 60, 3); }

TEST(DmsLaws, HoldAtThousandsOfPoints) { expect_laws(1000, 200, 5); }

}  // namespace
}  // namespace veritope
