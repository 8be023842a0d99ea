// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include "solids/micro/bifurcation.h"
#include "solids/micro/doubled_grids.h"
#include "solids/micro/fill_cage.h"
#include "solids/micro/micro_topology.h"
#include "solids/volumes/primitives.h"
#include "splines/knot_insertion.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using v_cells::cube;

struct DoubledCage {
  std::vector<VVolume> cage;
  VModel model;
  Microstructure micro;
};
DoubledCage doubled(std::vector<VVolume> cage, const std::array<std::uint64_t, 3>& counts,
                    std::uint64_t layer,
                    std::optional<std::array<std::int32_t, 2>> range = std::nullopt) {
  VModel model = make_v_model(cage, VOrientation::kAuto).value();
  JackShape shape;
  shape.degree = 1;
  shape.range = range;
  const auto with_arms = [shape](unsigned arms) {
    JackShape s = shape;
    s.arms = arms;
    return s;
  };
  const std::vector<TileOfArms> tiles = {
      [=](unsigned arms) { return jack_tile(with_arms(arms)); },
      [=](unsigned arms) { return bifurcation_tile(with_arms(arms & 31)); }};
  Microstructure micro =
      fill_grids(cage, model, make_doubled_grids(cage, counts, layer, 10000).value(), tiles,
                 [](const VVolume& volume, const MicroGrid& grid, std::uint64_t cell) {
                   return Result<std::size_t>(is_before_doubling(volume, grid, cell) ? 1 : 0);
                 })
          .value();
  return {std::move(cage), std::move(model), std::move(micro)};
}
MicroCounts counts_of(const DoubledCage& d) {
  std::vector<AnalysedTile> tiles;
  for (const MicroTile& t : d.micro.tiles) tiles.push_back(std::get<AnalysedTile>(analyse_tile(t)));
  const auto found = topology_of(d.micro, d.model, tiles);
  if (const auto* defect = std::get_if<MicroDefect>(&found)) {
    ADD_FAILURE() << defect->condition << ": " << defect->message;
    return {};
  }
  return std::get<MicroCounts>(found);
}

TEST(DoubledGrids, HalveTheCellsOfEachSpan) {
  const VVolume volume =
      refine(cube(0, 0, 0), 0, std::vector<Rational>{Rational(1) / Rational(10)});
  const auto grids = make_doubled_grids({volume}, {3, 1, 4}, 3, 10000).value();
  ASSERT_EQ(grids.size(), 2u);
  EXPECT_EQ(grids[0].tiles.size(), 9u);
  EXPECT_EQ(grids[1].tiles.size(), 12u);
  EXPECT_EQ(grids[0].breaks[2].back(), Rational(3) / Rational(4));
  EXPECT_EQ(grids[1].breaks[2].front(), Rational(3) / Rational(4));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(grids[1].breaks[0][2 * i], grids[0].breaks[0][i]);
  EXPECT_EQ(grids[1].breaks[0][1], Rational(1) / Rational(20));
  EXPECT_TRUE(is_before_doubling(volume, grids[0], 2));
  EXPECT_FALSE(is_before_doubling(volume, grids[0], 1));
  EXPECT_FALSE(is_before_doubling(volume, grids[1], 0));
}
TEST(DoubledGrids, RefuseLayersWithoutNeighbours) {
  for (const std::uint64_t layer : {0u, 4u, 5u})
    EXPECT_EQ(make_doubled_grids({cube(0, 0, 0)}, {3, 1, 4}, layer, 10000).error().code,
              Code::kBadArgument);
  EXPECT_TRUE(make_doubled_grids({cube(0, 0, 0)}, {3, 1, 4}, 1, 39));  // 3 + 3 * 12
  EXPECT_EQ(make_doubled_grids({cube(0, 0, 0)}, {3, 1, 4}, 1, 38).error().code, Code::kOverLimit);
  EXPECT_EQ(make_doubled_grids({cube(0, 0, 0)}, {0, 1, 4}, 1, 100).error().code,
            Code::kBadArgument);
}

// PROVES MICRO-1.T4
TEST(DoubledCage, HasTheGenusOfItsGraph) {
  for (const std::array<std::uint64_t, 4>& c :
       {std::array<std::uint64_t, 4>{1, 1, 2, 1}, {2, 2, 3, 2}, {3, 1, 4, 1}, {2, 3, 5, 3}}) {
    const auto [k, m, n, l] = c;
    const MicroCounts found = counts_of(doubled({cube(0, 0, 0)}, {k, m, n}, l));
    const auto block = [](std::uint64_t a, std::uint64_t b, std::uint64_t d) {
      return 3 * a * b * d - a * b - b * d - a * d;
    };
    const std::uint64_t tiles = k * m * l + 4 * k * m * (n - l),
                        links = block(k, m, l) + 4 * k * m + block(2 * k, 2 * m, n - l);
    EXPECT_EQ(found.tiles, tiles);
    EXPECT_EQ(found.glued_caps, links);
    EXPECT_EQ(found.components, 1u);
    EXPECT_EQ(found.shells, 1u);
    EXPECT_EQ(found.genus, static_cast<std::int64_t>(links + 1 - tiles));
  }
}

TEST(DoubledCage, VolumesBesideEachOtherAreDoubledTogether) {
  const MicroCounts found = counts_of(doubled({cube(0, 0, 0), cube(1, 0, 0)}, {1, 2, 3}, 2));
  const MicroCounts one = counts_of(doubled({cube(0, 0, 0)}, {2, 2, 3}, 2));
  EXPECT_EQ(found.genus, one.genus);
  EXPECT_EQ(found.glued_caps, one.glued_caps);
}

TEST(DoubledCage, FineWallsHaveTheNumberOfTheCoarseOneBelow) {
  DoubledCage d = doubled({cube(0, 0, 0)}, {2, 2, 3}, 2, {{1, 1000}});
  std::int32_t calls = 0;
  const auto next = [&](const GridWall&) { return Result<std::int32_t>(++calls); };
  ASSERT_TRUE(number_walls(d.model, next, d.micro));
  // 3 * 2 * 2 across u, as many across v and w; 5 * 4 across u, 20 across v, and 16 at the end of w.
  EXPECT_EQ(calls, 3 * 12 + 20 + 20 + 16);
  const auto& coarse = d.micro.grids[0].walls[2];
  const auto& fine = d.micro.grids[1].walls[2];
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      EXPECT_EQ(fine[(4 * i + j) * 2], coarse[(2 * (i / 2) + j / 2) * 3 + 2]);
  for (MicroTile& tile : d.micro.tiles) tile.range = {{kMaxWallNumber / 16, kMaxWallNumber / 8}};
  for (MicroGrid& grid : d.micro.grids)
    for (auto& walls : grid.walls)
      for (std::int32_t& n : walls) n = kMaxWallNumber / 16 + 10 * n;
  EXPECT_EQ(counts_of(d).components, 1u);
}

TEST(DoubledCage, LeavesOutArmsToCollapsedFaces) {
  const std::vector<VVolume> cage = cone_cells(Rational(1), Rational(0), Rational(1)).value();
  const MicroCounts found = counts_of(doubled(cage, {2, 2, 2}, 1));
  EXPECT_EQ(found.tiles, cage.size() * (4 + 16));
}

}  // namespace
}  // namespace veritope
