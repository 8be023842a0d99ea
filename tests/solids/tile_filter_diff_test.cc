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

// Axes of the cell exchanged and reversed, degrees raised, the mesh relabelled, all coordinates scaled by a power of two.
TEST(TileFilterLaw, OtherDescriptionsOfACellAreOneQuestion) {
  for (int n = 0; n < scaled(60); ++n) {
    Random random(kTileSeed + static_cast<std::uint64_t>(n));
    const Case c =
        n % 3 == 0 ? random_curved_case(random, n % 2 != 0) : random_case(random, n % 2 != 0);
    const TileFilter filter = std::move(TileFilter::make(c.solid.mesh).value());
    const TileShape shape = micro_tiles::shape_of(c.tile);
    const CellStatus status = filter.status({&c.map}, shape);
    const std::string where = "seed " + std::to_string(kTileSeed) + " case " + std::to_string(n);

    std::array<std::size_t, 3> order{0, 1, 2};
    for (std::uint64_t i = random.below(6); i > 0; --i)
      std::next_permutation(order.begin(), order.end());
    BezierVolume<Rational> turned = permuted(c.map, order);
    const std::size_t axis = random.below(3);
    turned = reversed(turned, axis);
    micro_tiles::Tile tile = c.tile;
    for (auto& patch : tile.patches) {
      const auto old = patch;
      for (std::size_t a = 0; a < 3; ++a) {
        const auto from = old.component(static_cast<int>(order[a]));
        const auto to = patch.component(static_cast<int>(a));
        for (std::size_t k = 0; k < to.size(); ++k)
          to[k] = a == axis ? Rational(1) - from[k] : from[k];
      }
    }
    EXPECT_EQ(filter.status({&turned}, micro_tiles::shape_of(tile)), status) << where;

    BezierVolume<Rational> raised = elevate(c.map, axis, 2);
    tile = c.tile;
    for (auto& patch : tile.patches) patch = elevate(patch, random.below(2), 1);
    EXPECT_EQ(filter.status({&raised}, micro_tiles::shape_of(tile)), status) << where;

    const int exponent = static_cast<int>(random.between(-40, 40));
    const TriangleMesh mesh = shapes::relabelled(shapes::scaled(c.solid.mesh, exponent), random);
    BezierVolume<Rational> scaled_map = c.map;
    for (int k = 0; k < 3; ++k)
      for (Rational& x : scaled_map.component(k)) x *= Rational::power_of_two(exponent);
    const TileFilter other = std::move(TileFilter::make(mesh).value());
    EXPECT_EQ(other.status({&scaled_map}, shape), status) << where;
  }
}

}  // namespace
}  // namespace veritope
