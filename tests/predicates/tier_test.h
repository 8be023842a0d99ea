// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/tier_test.h: which tier had to decide?
#pragma once
#include <gtest/gtest.h>

#include "robust/cascade.h"

namespace veritope {

/// `ask(tally)` answers `sign`, and exactly the tier `tier` decided.
template <typename Ask>
void expect_decided_by(Tier tier, Sign sign, Ask ask) {
  TierCounts tally;
  EXPECT_EQ(ask(&tally), sign);
  TierCounts expected;
  expected.decided[static_cast<std::size_t>(tier)] = 1;
  EXPECT_EQ(tally, expected) << "tiers: " << tally[Tier::kFilter] << ' ' << tally[Tier::kLattice]
                             << ' ' << tally[Tier::kInterval] << ' ' << tally[Tier::kExact];
  EXPECT_EQ(ask(nullptr), sign);
}

}  // namespace veritope
