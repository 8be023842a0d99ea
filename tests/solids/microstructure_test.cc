// SPDX-License-Identifier: LGPL-3.0-or-later
// What a microstructure must keep to, rule by rule; reading refuses most of it with a line: tests/io/micro_test.cc.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "solids/micro/micro_validity.h"

namespace veritope {
namespace {

VVolume micro_volume(const std::vector<Rational>& knots, int components = 3,
                     const Rational& weight = 0, bool is_periodic = false) {
  const KnotAxis<Rational> axis{1, knots, is_periodic}, other{1, {0, 0, 2, 2}, false};
  const std::size_t n = 4 * axis.num_control();
  const bool is_rational = weight.sign() != Sign::kZero;
  std::vector<Rational> coefficients(static_cast<std::size_t>(components) * n, Rational(1));
  if (is_rational) coefficients.insert(coefficients.end(), n, weight);
  return VVolume({axis, other, other}, components + (is_rational ? 1 : 0), is_rational,
                 std::move(coefficients));
}

MicroTile micro_tile(std::optional<int> wall) {
  MicroTile tile;
  if (wall) tile.range = {0, kMaxWallNumber};
  TilePatch patch;
  patch.wall = wall;
  patch.points = {std::vector<TilePoint>(4)};
  tile.patches = {patch, patch};
  return tile;
}

MicroGrid micro_grid(std::uint32_t volume, const std::vector<Rational>& x,
                     const std::vector<Rational>& y = {0, 1}) {
  MicroGrid grid;
  grid.volume = volume;
  grid.breaks = {x, y, std::vector<Rational>{0, 2}};
  grid.tiles.assign(grid.shape().count(), 1);
  for (std::size_t a = 0; a < 3; ++a) grid.walls[a].assign(grid.wall_shape(a).count(), 7);
  return grid;
}

Microstructure sound_micro() {
  Microstructure micro;
  micro.cage = {micro_volume({0, 0, 1, 2, 2}), micro_volume({0, 0, 2, 2}, 3, 5)};
  micro.tiles = {micro_tile(3), micro_tile(std::nullopt)};
  micro.grids = {micro_grid(0, {0, 1, 2}), micro_grid(0, {Rational(1, 2), 1}, {1, 2}),
                 micro_grid(1, {0, 2}, {0, 2})};
  return micro;
}

/// "ok" or "code: message" after a change.
std::string micro_answer(const std::function<void(Microstructure&)>& change) {
  Microstructure micro = sound_micro();
  change(micro);
  const Status status = validate(micro);
  return status ? "ok"
                : std::string(code_name(status.error().code)) + ": " + status.error().message;
}

using M = Microstructure;

TEST(Microstructure, ASoundOneIsAccepted) {
  EXPECT_EQ(micro_answer([](M&) {}), "ok");
  EXPECT_EQ(micro_answer([](M& m) { m.grids.clear(); }), "ok");
  EXPECT_EQ(micro_answer([](M& m) { m.model = {"a", std::string(64, 'a')}; }), "ok");
}

TEST(Microstructure, TheModelHasAHash) {
  for (const std::string& bad : {std::string(63, 'a'), std::string(64, 'A'), std::string(64, 'g')})
    EXPECT_EQ(
        micro_answer([&](M& m) {
          m.model = {"a", bad};
        }),
        "bad-argument: the model's sha256 must be 64 lower-case hexadecimal digits, not " + bad);
}

TEST(Microstructure, TheCageHasVolumesInSpace) {
  EXPECT_EQ(micro_answer([](M& m) { m.cage.clear(); }), "bad-argument: the cage has 0 volumes");
  EXPECT_EQ(micro_answer([](M& m) { m.cage.resize(65536, m.cage[1]); }), "ok");
  EXPECT_EQ(micro_answer([](M& m) { m.cage.resize(65537, m.cage[1]); }),
            "over-limit: the cage has 65537 volumes, more than 65536");
  for (const int components : {2, 4})
    EXPECT_EQ(micro_answer([&](M& m) {
                m.cage[1] = micro_volume({0, 0, 2, 2}, components);
              }),
              "bad-argument: volume 1 of the cage: it has " + std::to_string(components) +
                  " coordinates, not 3");
  EXPECT_EQ(micro_answer([](M& m) {
              m.cage[1] = micro_volume({-1, 0, 2, 2});
            }),
            "bad-argument: volume 1 of the cage: axis 0 is not clamped");
  EXPECT_EQ(micro_answer([](M& m) {
              m.cage[1] = micro_volume({0, 0, 2, 3});
            }),
            "bad-argument: volume 1 of the cage: axis 0 is not clamped");
  EXPECT_EQ(micro_answer([](M& m) {
              m.cage[1] = micro_volume({0, 0, 2, 2}, 3, 0, true);
            }),
            "bad-argument: volume 1 of the cage: axis 0 is not clamped");
  EXPECT_EQ(micro_answer([](M& m) {
              m.cage[1] = micro_volume({0, 0, 2, 2}, 3, -5);
            }),
            "bad-argument: volume 1 of the cage: the weight -5 is not positive");
}

TEST(Microstructure, TilesKeepTheirLimits) {
  EXPECT_EQ(micro_answer([](M& m) { m.tiles.resize(15, m.tiles[1]); }), "ok");
  EXPECT_EQ(micro_answer([](M& m) { m.tiles.resize(16, m.tiles[1]); }),
            "over-limit: there are 16 tiles, more than 15");
  EXPECT_EQ(micro_answer([](M& m) { m.tiles.clear(); }), "bad-argument: there are 0 tiles");
  EXPECT_EQ(micro_answer([](M& m) { m.tiles[1].patches.resize(1024, m.tiles[1].patches[0]); }),
            "ok");
  EXPECT_EQ(micro_answer([](M& m) { m.tiles[1].patches.resize(1025, m.tiles[1].patches[0]); }),
            "over-limit: tile 1: it has 1025 patches, more than 1024");
  EXPECT_EQ(micro_answer([](M& m) { m.tiles[1].patches.clear(); }),
            "bad-argument: tile 1: it has 0 patches");
}

TEST(Microstructure, RangesBelongToTilesThatNameWalls) {
  EXPECT_EQ(micro_answer([](M& m) { m.tiles[0].range = {5, 5}; }), "ok");
  const std::array<std::array<std::int32_t, 2>, 3> bad = {{{5, 4}, {-1, 4}, {0, (1 << 20) + 1}}};
  for (const auto& range : bad)
    EXPECT_EQ(micro_answer([&](M& m) { m.tiles[0].range = range; }),
              "bad-argument: tile 0: the range from " + std::to_string(range[0]) + " to " +
                  std::to_string(range[1]) + " is no range between 0 and 1048576");
  EXPECT_EQ(micro_answer([](M& m) { m.tiles[0].range.reset(); }),
            "bad-argument: tile 0: a patch names a wall, and there is no range");
  EXPECT_EQ(micro_answer([](M& m) {
              m.tiles[1].range = {0, 1};
            }),
            "bad-argument: tile 1: it has a range, and no patch names a wall");
  EXPECT_EQ(micro_answer([](M& m) { m.tiles[0].patches[0].wall.reset(); }), "ok");
}

TEST(Microstructure, PatchesKeepTheirLimits) {
  const auto with = [](const std::function<void(TilePatch&)>& change) {
    return micro_answer([&](M& m) { change(m.tiles[0].patches[1]); });
  };
  const std::string where = "tile 0: patch 1: ";
  for (const int wall : {0, 5}) EXPECT_EQ(with([&](TilePatch& p) { p.wall = wall; }), "ok");
  for (const int wall : {-1, 6})
    EXPECT_EQ(
        with([&](TilePatch& p) { p.wall = wall; }),
        "bad-argument: " + where + "the wall must be from 0 to 5, not " + std::to_string(wall));
  const auto of_degree = [](int degree) {
    return [degree](TilePatch& p) {
      p.degrees = {degree, 1};
      p.points = {std::vector<TilePoint>(2 * static_cast<std::size_t>(degree + 1))};
    };
  };
  EXPECT_EQ(with(of_degree(7)), "ok");
  EXPECT_EQ(with(of_degree(8)), "over-limit: " + where + "a degree must be from 1 to 7, not 8");
  EXPECT_EQ(with(of_degree(0)), "bad-argument: " + where + "a degree must be from 1 to 7, not 0");
  EXPECT_EQ(with([](TilePatch& p) { p.points.resize(4, p.points[0]); }), "ok");
  EXPECT_EQ(with([](TilePatch& p) { p.points.resize(5, p.points[0]); }),
            "over-limit: " + where + "it has 5 lists of points, more than 4");
  EXPECT_EQ(with([](TilePatch& p) { p.points.clear(); }),
            "bad-argument: " + where + "it has 0 lists of points");
  EXPECT_EQ(with([](TilePatch& p) { p.points.resize(2, p.points[0]), p.wall.reset(); }),
            "bad-argument: " + where + "it names no wall and has 2 lists of points, not 1");
  EXPECT_EQ(with([](TilePatch& p) { p.points[0].pop_back(); }),
            "bad-argument: " + where + "list 0 has 3 points, and the degrees (1, 1) need 4");
  const Rational most = Rational::power_of_two(128) - 1;
  for (const Rational& x : {most, -most, Rational(1) / most})
    EXPECT_EQ(with([&](TilePatch& p) { p.points[0][3][2] = x; }), "ok");
  for (const Rational& x : {most + 1, -most - 1, Rational::power_of_two(-128)})
    EXPECT_EQ(with([&](TilePatch& p) { p.points[0][3][2] = x; }),
              "over-limit: " + where +
                  "coordinate 2 of point 3 of list 0 has a numerator or "
                  "denominator of more than 128 bits: " +
                  x.to_string());
}

TEST(Microstructure, BreaksRiseInTheDomainAndHaveTheKnots) {
  const auto with = [](const std::vector<Rational>& breaks) {
    return micro_answer([&](M& m) {
      m.grids = {micro_grid(0, {0, 1, 2})};
      m.grids[0].breaks[0] = breaks;
    });
  };
  const std::string where = "bad-argument: grid 0: axis 0: ";
  EXPECT_EQ(with({0, 1, 2}), "ok");
  EXPECT_EQ(with({}), where + "at least 2 breaks are needed, and there are 0");
  EXPECT_EQ(with({0}), where + "at least 2 breaks are needed, and there are 1");
  EXPECT_EQ(with({0, 2, 1}), where + "break 2, 1, is not above the one before it, 2");
  EXPECT_EQ(with({0, 1, 1}), where + "break 2, 1, is not above the one before it, 1");
  EXPECT_EQ(with({-1, 1, 2}), where + "the break -1 is not in the domain from 0 to 2");
  EXPECT_EQ(with({0, 1, 3}), where + "the break 3 is not in the domain from 0 to 2");
  EXPECT_EQ(with({0, Rational(3, 2), 2}), where + "the knot 1 is no break");
  EXPECT_EQ(with({Rational(1, 2), Rational(3, 4), 1}), "ok");  // a knot at the end
}

TEST(Microstructure, GridsComeByVolumesWithDisjointInsides) {
  EXPECT_EQ(micro_answer([](M& m) { m.grids[2].volume = 2; }),
            "bad-argument: grid 2: volume 2 is not one of the 2 volumes of the cage");
  EXPECT_EQ(micro_answer([](M& m) { m.grids[0].volume = 1; }),
            "bad-argument: grid 1: its volume, 0, is below that of the grid before it, 1");
  EXPECT_EQ(micro_answer([](M& m) {
              m.grids[1] = micro_grid(0, {Rational(1, 2), 1}, {Rational(1, 2), 2});
            }),
            "bad-argument: the boxes of the grids 0 and 1 of volume 0 have inner points in common");
  EXPECT_EQ(micro_answer([](M& m) {
              m.grids = {micro_grid(1, {1, 2}), micro_grid(1, {0, 1}),
                         micro_grid(1, {0, 2}, {1, 2}),
                         micro_grid(1, {Rational(1, 3), Rational(1, 2)}, {Rational(1, 3), 1})};
            }),
            "bad-argument: the boxes of the grids 1 and 3 of volume 1 have inner points in common");
}

TEST(Microstructure, AtMost65536GridsAnd4096OfAVolumeAnd2To27Cells) {
  const auto with = [](int count) {
    return micro_answer([count](M& m) {
      m.grids.clear();
      for (int i = 0; i < count; ++i)
        m.grids.push_back(micro_grid(1, {Rational(i, 2500), Rational(i + 1, 2500)}));
    });
  };
  EXPECT_EQ(with(4096), "ok");
  EXPECT_EQ(with(4097), "over-limit: volume 1 has more than 4096 grids");
  const auto with_volumes = [](std::uint32_t count) {
    return micro_answer([count](M& m) {
      m.grids.clear();
      m.cage.resize(65536, m.cage[1]);
      for (std::uint32_t v = 0; v < count; ++v)
        m.grids.push_back(micro_grid(v == 0 ? 1 : std::min(v, 65535u), {0, 2}, {0, 2}));
      m.grids[0].breaks[0][1] = 1;
      m.grids[1].breaks[0][0] = 1;
    });
  };
  EXPECT_EQ(with_volumes(65536), "ok");
  EXPECT_EQ(with_volumes(65537), "over-limit: there are 65537 grids, more than 65536");
  Microstructure micro = sound_micro();
  MicroGrid& grid = micro.grids[0];
  for (auto& breaks : grid.breaks) {
    breaks.clear();
    for (int i = 0; i <= 512; ++i) breaks.emplace_back(i, 256);
  }
  std::uint64_t cells = 0;
  EXPECT_TRUE(check_breaks(micro, 0, cells));
  EXPECT_EQ(cells, std::uint64_t{1} << 27);
  const Status one_more = check_breaks(micro, 1, cells);
  ASSERT_FALSE(one_more);
  EXPECT_EQ(to_string(one_more.error()), "grid 1: the grids have more than 134217728 cells");
}

TEST(Microstructure, CellsHoldTilesOfTheList) {
  EXPECT_EQ(micro_answer([](M& m) { m.grids[0].tiles[1] = 2; }), "ok");
  EXPECT_EQ(micro_answer([](M& m) { m.grids[0].tiles[1] = 3; }),
            "bad-argument: grid 0: cell 1 holds tile 2 of 2");
  EXPECT_EQ(micro_answer([](M& m) { m.grids[0].tiles.pop_back(); }),
            "bad-argument: grid 0: it has 2 cells, and the contents of 1 are given");
}

TEST(Microstructure, WallsHaveNumbersBesideTiles) {
  EXPECT_EQ(micro_answer([](M& m) { m.grids[0].walls[0][1] = 1 << 20; }), "ok");
  for (const int number : {-1, (1 << 20) + 1})
    EXPECT_EQ(micro_answer([&](M& m) { m.grids[0].walls[0][1] = number; }),
              "bad-argument: grid 0: axis 0: the number of wall 1 must be from 0 to 1048576, not " +
                  std::to_string(number));
  EXPECT_EQ(micro_answer([](M& m) { m.grids[0].walls[2].pop_back(); }),
            "bad-argument: grid 0: axis 2: 4 numbers of walls are needed, and there are 3");
  EXPECT_EQ(micro_answer([](M& m) {
              m.grids[0].tiles = {1, 0};
            }),
            "bad-argument: grid 0: axis 0: wall 2 has the number 7, and no neighbour holds a tile");
  EXPECT_EQ(micro_answer([](M& m) {
              m.grids[0].tiles = {0, 1};
            }),
            "bad-argument: grid 0: axis 0: wall 0 has the number 7, and no neighbour holds a tile");
  EXPECT_EQ(micro_answer([](M& m) {
              m.grids[0].tiles = {1, 0}, m.grids[0].walls[0][2] = 0;
              m.grids[0].walls[1] = {7, 7, 0, 0}, m.grids[0].walls[2] = {7, 7, 0, 7};
            }),
            "bad-argument: grid 0: axis 2: wall 3 has the number 7, and no neighbour holds a tile");
  EXPECT_EQ(micro_answer([](M& m) { m.tiles.erase(m.tiles.begin()); }),
            "bad-argument: grid 0: axis 0: 0 numbers of walls are needed, and there are 3");
  EXPECT_EQ(micro_answer([](M& m) {
              m.tiles.erase(m.tiles.begin());
              for (MicroGrid& grid : m.grids) grid.walls = {};
            }),
            "ok");
}

}  // namespace
}  // namespace veritope
