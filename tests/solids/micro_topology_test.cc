// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "solids/micro/fill_cage.h"
#include "solids/micro/micro_topology.h"
#include "solids/volumes/primitives.h"
#include "splines/knot_insertion.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using v_cells::cube;

std::variant<MicroCounts, MicroDefect> topology(const Microstructure& micro) {
  std::vector<AnalysedTile> tiles;
  for (const MicroTile& t : micro.tiles) tiles.push_back(std::get<AnalysedTile>(analyse_tile(t)));
  return topology_of(micro, make_v_model(micro.cage, VOrientation::kAuto).value(), tiles);
}
MicroCounts counts_of(const Microstructure& micro) {
  const auto found = topology(micro);
  if (const auto* defect = std::get_if<MicroDefect>(&found)) {
    ADD_FAILURE() << defect->condition << ": " << defect->message;
    return {};
  }
  return std::get<MicroCounts>(found);
}
std::string condition_of(const Microstructure& micro) {
  const auto found = topology(micro);
  const auto* defect = std::get_if<MicroDefect>(&found);
  return defect != nullptr ? defect->condition : "";
}
MicroTile jack(std::optional<std::array<std::int32_t, 2>> range = std::nullopt) {
  JackShape shape;
  shape.degree = 1;
  shape.range = range;
  return jack_tile(shape).value();
}
constexpr std::int32_t kEighth = kMaxWallNumber / 8;

// PROVES MICRO-1
TEST(MicroTopology, BlocksOfJacksHaveTheGenusOfTheirGraph) {
  for (const std::array<std::uint64_t, 3>& n :
       {std::array<std::uint64_t, 3>{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {3, 4, 5}}) {
    const MicroCounts c = counts_of(full({cube(0, 0, 0)}, n, jack()));
    const auto [k, l, m] = n;
    EXPECT_EQ(c.tiles, k * l * m);
    EXPECT_EQ(c.glued_caps, 3 * k * l * m - k * l - l * m - k * m);
    EXPECT_EQ(c.components, 1u);
    EXPECT_EQ(c.shells, 1u);
    EXPECT_EQ(c.genus, static_cast<std::int64_t>(2 * k * l * m + 1 - k * l - l * m - k * m));
  }
}

TEST(MicroTopology, EmptyCellsCutTheStructure) {
  Microstructure micro = full({cube(0, 0, 0)}, {3, 1, 1}, jack());
  micro.grids[0].tiles[1] = 0;
  const MicroCounts c = counts_of(micro);
  EXPECT_EQ(c.tiles, 2u);
  EXPECT_EQ(c.components, 2u);
  EXPECT_EQ(c.shells, 2u);
  EXPECT_EQ(c.genus, 0);
}

TEST(MicroTopology, TheLargestComponentIsKept) {
  Microstructure micro = full({cube(0, 0, 0)}, {6, 1, 1}, jack());
  micro.grids[0].tiles[1] = micro.grids[0].tiles[4] = 0;  // 1, 2 and 1 tiles
  const VModel cage = make_v_model(micro.cage, VOrientation::kAuto).value();
  const std::vector<AnalysedTile> tiles = {std::get<AnalysedTile>(analyse_tile(micro.tiles[0]))};
  const auto floating = keep_largest_component(cage, tiles, micro);
  EXPECT_EQ(std::get<0>(floating), (std::vector<std::vector<std::uint64_t>>{{0, 5}}));
  EXPECT_EQ(counts_of(micro).tiles, 2u);
  EXPECT_EQ(counts_of(micro).components, 1u);
}

// PROVES MICRO-1.G1
TEST(MicroTopology, NumbersOfWallsLieInTheRangeOfTheTile) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 1, 1}, jack({{kEighth, 2 * kEighth}}), kEighth);
  EXPECT_EQ(condition_of(micro), "");
  micro.grids[0].walls[0][1] = 2 * kEighth;
  EXPECT_EQ(condition_of(micro), "");
  micro.grids[0].walls[0][1] = 2 * kEighth + 1;
  EXPECT_EQ(condition_of(micro), "G1");
}

// PROVES MICRO-1.T4
TEST(MicroTopology, GluedVolumesShareTheNumbersOfTheirCommonWalls) {
  Microstructure micro =
      full({cube(0, 0, 0), cube(1, 0, 0)}, {2, 2, 2}, jack({{kEighth, 2 * kEighth}}), kEighth);
  MicroCounts c = counts_of(micro);
  EXPECT_EQ(c.tiles, 16u);
  EXPECT_EQ(c.components, 1u);
  EXPECT_EQ(c.genus, 2 * 16 + 1 - 4 * 2 - 4 * 2 - 4);  // a block of 4 x 2 x 2
  micro.grids[1].walls[0][0] = kEighth + 1;
  EXPECT_EQ(condition_of(micro), "T4");
  micro.grids[0].walls[0][8] = kEighth + 1;  // the same wall, in the other volume
  EXPECT_EQ(condition_of(micro), "");
}

TEST(MicroTopology, EverySymmetryOfAGluedFaceIsFollowed) {
  for (int round = 0; round < 60; ++round) {
    std::vector<VVolume> cage = {cube(0, 0, 0),
                                 v_cells::turned(cube(1, 0, 0), static_cast<unsigned>(round) % 48)};
    // Different numbers of cells along all axes: only the right symmetry brings equal walls together.
    const Microstructure micro = full(cage, {2, 2, 2}, jack());
    const MicroCounts c = counts_of(micro);
    EXPECT_EQ(c.components, 1u) << round;
    EXPECT_EQ(c.genus, 2 * 16 + 1 - 4 * 2 - 4 * 2 - 4) << round;
  }
}

// PROVES MICRO-1.T4
TEST(MicroTopology, OverlappingCapsOfDifferentTilesAreRefused) {
  Microstructure micro = full({cube(0, 0, 0)}, {1, 1, 2}, box_tile({16, 16, 0}, {48, 48, 64}));
  micro.tiles.push_back(box_tile({20, 16, 0}, {52, 48, 64}));
  EXPECT_EQ(counts_of(micro).components, 1u);
  micro.grids[0].tiles[1] = 2;
  EXPECT_EQ(condition_of(micro), "T4");
  micro.tiles[1] = box_tile({50, 16, 0}, {60, 48, 64});  // apart
  EXPECT_EQ(counts_of(micro).components, 2u);
  micro.tiles[1] = box_tile({48, 16, 0}, {60, 48, 64});  // the caps touch in a side
  EXPECT_EQ(condition_of(micro), "T4");
}

std::vector<VVolume> cone() { return cone_cells(Rational(1), Rational(0), Rational(1)).value(); }

// PROVES MICRO-1.G2
TEST(MicroTopology, NoCapLiesInAFaceThatIsCollapsed) {
  EXPECT_EQ(condition_of(full(cone(), {1, 1, 1}, jack())), "G2");
}
TEST(FillCage, LeavesOutArmsToFacesThatAreCollapsed) {
  const std::vector<VVolume> cage = cone();
  const VModel model = make_v_model(cage, VOrientation::kAuto).value();
  JackShape shape;
  const auto tile = [&](unsigned arms) {
    shape.arms = arms;
    return jack_tile(shape);
  };
  const Microstructure micro = fill_cage(cage, model, {2, 2, 2}, tile, 40).value();
  const MicroCounts c = counts_of(micro);
  EXPECT_EQ(micro.tiles.size(), 2u);
  EXPECT_EQ(c.tiles, 40u);
  EXPECT_EQ(c.components, 1u);
  EXPECT_EQ(fill_cage(cage, model, {2, 2, 2}, tile, 39).error().code, Code::kOverLimit);
  EXPECT_EQ(fill_cage(cage, model, {0, 2, 2}, tile, 40).error().code, Code::kBadArgument);
}
TEST(FillCage, ACommonWallOfTwoVolumesHasOneNumber) {
  const std::vector<VVolume> cage = {cube(0, 0, 0), v_cells::turned(cube(1, 0, 0), 13)};
  const VModel model = make_v_model(cage, VOrientation::kAuto).value();
  Microstructure micro = fill_cage(
                             cage, model, {2, 2, 2},
                             [](unsigned) {
                               return Result(jack({{1, 100}}));
                             },
                             16)
                             .value();
  std::int32_t calls = 0;
  const auto next = [&](const GridWall&) { return Result<std::int32_t>(++calls); };
  ASSERT_TRUE(number_walls(model, next, micro));
  EXPECT_EQ(calls, 2 * 36 - 4);
  EXPECT_EQ(counts_of(micro).components, 1u);
  micro.grids[0].tiles.assign(8, 0);
  clear_unused_walls(micro);
  EXPECT_EQ(std::count(micro.grids[0].walls[0].begin(), micro.grids[0].walls[0].end(), 0), 12);
}
TEST(MicroGrid, CellsAreSharedOutAmongSpansByTheirLength) {
  const VVolume volume =
      refine(cube(0, 0, 0), 0,
             std::vector<Rational>{Rational(1) / Rational(10), Rational(1) / Rational(2)});
  const MicroGrid grid = make_micro_grid(volume, 0, {7, 1, 2}).value();
  // Spans of 1/10, 4/10, 5/10: one each, and 4 by 0.4, 1.6, 2: 0, 1, 2 and the one that is left for the second.
  ASSERT_EQ(grid.breaks[0].size(), 8u);
  EXPECT_EQ(grid.breaks[0][1], Rational(1) / Rational(10));
  EXPECT_EQ(grid.breaks[0][4], Rational(1) / Rational(2));
  EXPECT_EQ(grid.breaks[0][5], Rational(2) / Rational(3));
  EXPECT_EQ(grid.tiles.size(), 14u);
  EXPECT_EQ(make_micro_grid(volume, 0, {2, 1, 1}).error().code, Code::kBadArgument);
  EXPECT_EQ(make_micro_grid(volume, 0, {1u << 20, 1u << 20, 1}).error().code, Code::kOverLimit);
}

TEST(MicroTopology, FineGridsMeetCoarseOnes) {
  // A coarse cell below 2 x 2 fine ones; the coarse tile has four caps on top, each that of a fine tile.
  Microstructure micro = full({cube(0, 0, 0)}, {1, 1, 1}, box_tile({8, 8, 0}, {24, 24, 64}));
  const Rational half = Rational(1) / Rational(2);
  micro.grids[0].breaks[2] = {Rational(0), half};
  MicroGrid fine = micro.grids[0];
  fine.breaks = {
      {{Rational(0), half, Rational(1)}, {Rational(0), half, Rational(1)}, {half, Rational(1)}}};
  fine.tiles.assign(4, 0);
  micro.grids.push_back(fine);
  micro.tiles.push_back(box_tile({16, 16, 0}, {48, 48, 64}));
  micro.grids[1].tiles[0] = 2;  // over the first quarter: its cap is [16, 48] / 128 = [8, 24] / 64
  MicroCounts c = counts_of(micro);
  EXPECT_EQ(c.components, 1u);
  EXPECT_EQ(c.glued_caps, 1u);
  micro.grids[1].tiles[0] = 0;
  micro.grids[1].tiles[3] = 2;
  EXPECT_EQ(counts_of(micro).components, 2u);
}

// A box whose cap in wall 0, or 1, is a ring around a dent. Patches: four sides, the far face, four of the dent's sides,
// its bottom, four of the ring.
MicroTile bowl(bool is_at_end) {
  const auto corner = [&](int x, int half, std::size_t i) {
    constexpr std::array<std::array<int, 2>, 4> kSigns = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    return micro_cells::at(is_at_end ? 64 - x : x, 32 + half * kSigns[i % 4][0],
                           32 + half * kSigns[i % 4][1]);
  };
  MicroTile out;
  const auto add = [&](const TilePoint& a, const TilePoint& b, const TilePoint& c,
                       const TilePoint& d) {
    out.patches.push_back(is_at_end ? micro_cells::square(d, c, b, a)
                                    : micro_cells::square(a, b, c, d));
  };
  // Rings of corners at a height over the wall and half a width, and the strips between two of them.
  const auto strips = [&](int x, int half, int x2, int half2) {
    for (std::size_t i = 0; i < 4; ++i)
      add(corner(x, half, i), corner(x, half, i + 1), corner(x2, half2, i + 1),
          corner(x2, half2, i));
  };
  const auto lid = [&](int x, int half, bool is_turned) {
    const std::size_t b = is_turned ? 3 : 1;
    add(corner(x, half, 0), corner(x, half, b), corner(x, half, 2), corner(x, half, 4 - b));
  };
  strips(0, 24, 32, 24);
  lid(32, 24, false);
  strips(8, 8, 0, 16);
  lid(8, 8, true);
  strips(0, 16, 0, 24);
  return out;
}

TEST(MicroTopology, EachShellHasAFirstPatch) {
  Microstructure micro = full({cube(0, 0, 0)}, {3, 1, 1}, bowl(true));
  micro.tiles.push_back(bowl(false));
  micro.grids[0].tiles = {2, 1, 2};
  std::vector<AnalysedTile> tiles;
  for (const MicroTile& t : micro.tiles) {
    const auto analysed = analyse_tile(t);
    const auto* const defect = std::get_if<TileDefect>(&analysed);
    ASSERT_EQ(defect, nullptr) << defect->condition << defect->message;
    tiles.push_back(std::get<AnalysedTile>(analysed));
  }
  std::vector<CellPatch> first;
  const auto counts =
      topology_of(micro, make_v_model(micro.cage, VOrientation::kAuto).value(), tiles, &first);
  // One bowl alone; two that enclose a hole, whose surface begins with a side of a dent.
  EXPECT_EQ(std::get<MicroCounts>(counts).shells, 3u);
  EXPECT_EQ(std::get<MicroCounts>(counts).components, 2u);
  EXPECT_EQ(first, (std::vector<CellPatch>{{0, 0, 0}, {0, 1, 0}, {0, 1, 5}}));
  first.clear();
  micro.grids[0].tiles = {2, 0, 2};
  topology_of(micro, make_v_model(micro.cage, VOrientation::kAuto).value(), tiles, &first);
  EXPECT_EQ(first, (std::vector<CellPatch>{{0, 0, 0}, {0, 2, 0}}));
}

TEST(MicroTopology, ShellsThatCapsCutApartAreJoinedAgain) {
  // A box between two walls: without its caps it is a tube, one shell. Three of them on each other: one shell.
  const MicroCounts c =
      counts_of(full({cube(0, 0, 0)}, {1, 1, 3}, box_tile({16, 16, 0}, {48, 48, 64})));
  EXPECT_EQ(c.shells, 1u);
  EXPECT_EQ(c.genus, 0);
}

}  // namespace
}  // namespace veritope
