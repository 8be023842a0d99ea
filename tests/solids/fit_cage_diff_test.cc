// SPDX-License-Identifier: LGPL-3.0-or-later
// Cages that are fitted to fields of known cages, beside those.
#include <gtest/gtest.h>

#include "solids/micro/cage/fit_cage.h"
#include "tests/solids/cage_support.h"
#include "tests/support/random_fields.h"

namespace veritope {
namespace {

using namespace cage_test;
using namespace random_fields;

TEST(FitCageDiff, FollowsTheLinesOfKnownCages) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const CellVolume cage = random_cage(random);
    const Sample given = sample(random, cage, 500, seed == 2 ? 0.01 : 0);
    FitCageOptions options;
    options.grid.spans = {2, 2, 2};
    options.margin = margin_length(box_of(given.field, {}), q(1, 20));
    const FitCage fit = fit_cage(given.field, {}, options).value();
    EXPECT_TRUE(decide_determinants(model_of({fit.cell})).is_proved());
    EXPECT_LT(median(angles(fit.cell, given.field.points, given.truth)), 1.5);
  }
}

}  // namespace
}  // namespace veritope
