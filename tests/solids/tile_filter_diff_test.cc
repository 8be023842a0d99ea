// SPDX-License-Identifier: LGPL-3.0-or-later
// Random tiles against their truth in fractions; bench/soak_micro_filter.cc runs more of them.
#include <gtest/gtest.h>

#include "solids/micro/filter/tile_filter.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/micro_truth.h"

namespace veritope {
namespace {

using namespace micro_truth;

constexpr std::uint64_t kTileSeed = 20261128;

TEST(TileFilterDiff, EveryStatusInAffineCellsIsRight) {
  std::array<int, 5> seen{};
  for (int n = 0; n < scaled(300); ++n) {
    Random random(kTileSeed + static_cast<std::uint64_t>(n));
    const Case c = random_case(random, n % 2 != 0);
    const TileFilter filter = std::move(TileFilter::make(c.solid.mesh).value());
    const TileShape shape = micro_tiles::shape_of(c.tile);
    const CellMap cell{&c.map};
    const CellFinding finding = filter.find(cell, shape);
    const Facts facts = c.solid.facts(c.parts());
    ASSERT_EQ(fault_of(c, cell, shape, finding, facts), "")
        << "seed " << kTileSeed << " case " << n << "\n"
        << c.text();
    ASSERT_TRUE(finding.status != CellStatus::kUndecided || facts.status() == CellStatus::kTouching)
        << "seed " << kTileSeed << " case " << n << "\n"
        << c.text();
    ++seen[static_cast<std::size_t>(finding.status)];
  }
  for (std::size_t s = 0; s < 4; ++s) EXPECT_GT(seen[s], 0) << s;
}

TEST(TileFilterDiff, ExactPointsInCurvedCellsContradictNoStatus) {
  for (int n = 0; n < scaled(60); ++n) {
    Random random(kTileSeed + static_cast<std::uint64_t>(n));
    const Case c = random_curved_case(random, n % 2 != 0);
    const TileFilter filter = std::move(TileFilter::make(c.solid.mesh).value());
    const TileShape shape = micro_tiles::shape_of(c.tile);
    const CellMap cell{&c.map};
    const CellFinding finding = filter.find(cell, shape);
    ASSERT_NE(finding.status, CellStatus::kUndecided)
        << "seed " << kTileSeed << " case " << n << "\n"
        << c.text();
    std::string fault = fault_of(c, cell, shape, finding, std::nullopt);
    if (fault.empty()) fault = contradiction_of(c, cell, finding.status, 100, random);
    ASSERT_EQ(fault, "") << "seed " << kTileSeed << " case " << n << "\n" << c.text();
  }
}

}  // namespace
}  // namespace veritope
