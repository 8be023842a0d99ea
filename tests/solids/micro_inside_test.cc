// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "splines/knot_insertion.h"
#include "tests/support/micro_cells.h"
#include "tests/support/micro_inside.h"
#include "tests/support/random_microstructures.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using micro_inside::answer;
using micro_inside::Answer;
using micro_inside::condition_of;
using v_cells::cube;

Rational ratio(int p, int q) { return Rational(p) / Rational(q); }

MicroTile inner_jack(int degree = 1) {
  JackShape shape;
  shape.degree = degree;
  return jack_tile(shape).value();
}
TriangleMesh cuboid(double lo, double hi) { return shapes::box({lo, lo, lo}, {hi, hi, hi}); }
TriangleMesh bubble(Vec3d middle, double half) {
  return shapes::reversed(shapes::box({middle.x - half, middle.y - half, middle.z - half},
                                      {middle.x + half, middle.y + half, middle.z + half}));
}
TriangleMesh with_bubble(Vec3d middle, double half) {
  return shapes::joined(cuboid(-4, 5), bubble(middle, half));
}

// PROVES MICRO-2, MICRO-2.I1
TEST(MicroInside, ATileThatTouchesOrCrossesTheSurfaceIsNotInside) {
  const Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, inner_jack());
  EXPECT_EQ(condition_of(answer(micro, cuboid(-0.125, 1.125))), "");
  // Caps lie in the planes of the cube's faces.
  EXPECT_EQ(condition_of(answer(micro, cuboid(-0x1p-38, 1 + 0x1p-38))), "");
  EXPECT_EQ(condition_of(answer(micro, cuboid(-0x1p-44, 1 + 0x1p-44))), "I1");  // checkers do not see it
  EXPECT_EQ(condition_of(answer(micro, cuboid(0, 1))), "I1");
  EXPECT_EQ(condition_of(answer(micro, cuboid(0.125, 1.125))), "I1");
  EXPECT_EQ(condition_of(answer(micro, with_bubble({0.25, 0.25, 0.45}, 0.07))), "I1");
  const Answer crossing = answer(micro, with_bubble({0.75, 0.25, 0.25}, 0.2));
  ASSERT_EQ(condition_of(crossing), "I1");
  const auto& defect = std::get<InsideDefect>(crossing);
  ASSERT_TRUE(defect.patch.has_value() && defect.source.has_value());
  EXPECT_EQ(defect.patch->cell, 4u);
  EXPECT_GE(*defect.source, 12u);
  EXPECT_NE(defect.message.find("cell (1, 0, 0) of grid 0 is not proved to miss triangle"),
            std::string::npos);
}

// PROVES MICRO-2.I2
TEST(MicroInside, EachPieceMustBeInTheSolid) {
  Microstructure micro = full({cube(0, 0, 0)}, {3, 1, 1}, inner_jack());
  micro.grids[0].tiles[1] = 0;
  EXPECT_EQ(condition_of(answer(micro, cuboid(-1, 2))), "");
  EXPECT_EQ(condition_of(answer(micro, cuboid(3, 4))), "I2");
  // One piece is in a void, behind which there is a bubble's surface.
  const TriangleMesh hollow = shapes::joined(
      cuboid(-1, 2), shapes::reversed(shapes::box({0.5, -0.5, -0.5}, {1.5, 1.5, 1.5})));
  const Answer in_void = answer(micro, hollow);
  ASSERT_EQ(condition_of(in_void), "I2");
  EXPECT_EQ(std::get<InsideDefect>(in_void).patch->cell, 2u);
  // A solid in the void, around that piece.
  const TriangleMesh nested =
      shapes::joined(hollow, shapes::box({0.625, -0.25, -0.25}, {1.25, 1.25, 1.25}));
  EXPECT_EQ(condition_of(answer(micro, nested)), "");
}

TEST(MicroInside, ShellsBegunInOneTileAreAskedOneByOne) {
  // A closed box has one shell, and so have two boxes that meet in a cap.
  const Microstructure micro =
      full({cube(0, 0, 0)}, {2, 1, 1}, box_tile({0, 16, 16}, {64, 48, 48}));
  EXPECT_EQ(condition_of(answer(micro, cuboid(-1, 2))), "");
  EXPECT_EQ(condition_of(answer(micro, cuboid(2, 3))), "I2");
}

// PROVES MICRO-2.I3
TEST(MicroInside, BehindEachVoidAPointIsOffTheTiles) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, inner_jack());
  micro.grids[0].tiles[7] = 0;
  struct Case {
    Vec3d middle;
    double half;
    const char* condition;
  };
  for (const Case& c :
       {Case{{0.25, 0.25, 0.25}, 0.05, "I3"},  // in the node of a jack
        Case{{0.25, 0.25, 0.45}, 0.01, "I3"},  // in an arm
        Case{{0.75, 0.75, 0.75}, 0.05, ""},    // in the empty cell
        Case{{0.06, 0.06, 0.06}, 0.05, ""},    // near a corner of a cell
        Case{{0.4375, 0.4375, 0.0625}, 0.03, ""}, Case{{0.0625, 0.4375, 0.4375}, 0.001, ""},
        Case{{0.5, 0.5, 0.5}, 0.1, ""},  // around a corner of eight cells
        Case{{3, 3, 3}, 0.5, "I3"}}) {   // off the cage: no point of it helps
    const TriangleMesh mesh = with_bubble(c.middle, c.half);
    const Answer got = answer(micro, mesh);
    EXPECT_EQ(condition_of(got), c.condition) << c.middle.x << " " << c.middle.y;
    if (condition_of(got) != "") continue;
    const auto& voids = std::get<InsideProof>(got).voids;
    ASSERT_EQ(voids.size(), 1u);
    // The cage is the identity.
    const std::array<double, 3> middle = {c.middle.x, c.middle.y, c.middle.z};
    bool is_in_empty_cell = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const Rational off = voids[0].x[a] - Rational::from_double(middle[a]);
      EXPECT_LT(off < Rational(0) ? -off : off, Rational::from_double(c.half));
      is_in_empty_cell = is_in_empty_cell && ratio(1, 2) < voids[0].x[a];
    }
    EXPECT_EQ(voids[0].corner == 8, is_in_empty_cell);
  }
}

TEST(MicroInside, VoidsAreListedByTheirShells) {
  const Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, inner_jack());
  TriangleMesh mesh = cuboid(-4, 5);
  const std::vector<Vec3d> middles = {
      {0.5, 0.5, 0.5}, {0.0625, 0.0625, 0.0625}, {0.5, 0.5, 0.9375}};
  for (const Vec3d& m : middles) mesh = shapes::joined(mesh, bubble(m, 0.03125));
  mesh = shapes::joined(mesh, cuboid(6, 7));
  const Answer got = answer(micro, mesh);
  ASSERT_EQ(condition_of(got), "");
  const auto& voids = std::get<InsideProof>(got).voids;
  ASSERT_EQ(voids.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT((voids[i].x[2] - Rational::from_double(middles[i].z)) *
                  (voids[i].x[2] - Rational::from_double(middles[i].z)),
              ratio(1, 1024));
}

// A cube of 2 x 1 x 1 cells, the second one empty, with a bridge from the cap between them, whose end has the first
// parameters u, one for each corner.
Microstructure bridged(const std::array<Rational, 4>& ends) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 1, 1}, box_tile({0, 16, 16}, {64, 48, 48}));
  micro.grids[0].tiles[1] = 0;
  MicroBridge b;
  b.cap = {0, 0, 1};
  b.points.resize(b.num_points());
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 3; ++k) {
        const Rational& end = ends[static_cast<std::size_t>(2 * i + j)];
        b.points[b.at(i, j, k)] = {ratio(1, 2) + (end - ratio(1, 2)) * ratio(k, 2),
                                   ratio(1 + 2 * i, 4), ratio(1 + 2 * j, 4)};
      }
  micro.bridges.push_back(std::move(b));
  return micro;
}

// PROVES MICRO-2.I4
TEST(MicroInside, TheSkinIsNearlyTheGreatestDistanceOfAnEnd) {
  const Rational e = ratio(7, 8);
  // No edge of a triangle passes behind the end.
  for (const double gap : {0x1p-30, 0.01, 0.125, 0.75}) {
    const TriangleMesh mesh = shapes::box({-4, -4, -4}, {0.875 + gap, 12, 4});
    const Answer got = answer(bridged({e, e, e, e}), mesh);
    ASSERT_EQ(condition_of(got), "") << gap;
    const Rational skin = *std::get<InsideProof>(got).skin, truth = Rational::from_double(gap);
    EXPECT_GT(skin, truth) << gap;
    EXPECT_LT(skin, truth * ratio(65, 64)) << gap;
    EXPECT_LE(skin.numerator().bit_length(), 20u);
  }
  // A slanted end, whose far corner decides.
  const Answer slanted =
      answer(bridged({ratio(6, 8), ratio(6, 8), e, e}), shapes::box({-4, -4, -4}, {1, 4, 4}));
  ASSERT_EQ(condition_of(slanted), "");
  EXPECT_GT(*std::get<InsideProof>(slanted).skin, ratio(1, 4));
  EXPECT_LT(*std::get<InsideProof>(slanted).skin, ratio(1, 4) * ratio(65, 64));
  EXPECT_FALSE(
      std::get<InsideProof>(answer(full({cube(0, 0, 0)}, {1, 1, 1}, inner_jack()), cuboid(-1, 2)))
          .skin.has_value());
}

// PROVES MICRO-2, MICRO-2.I1
TEST(MicroInside, ABridgeThatTouchesOrCrossesTheSurfaceIsNotInside) {
  const Rational e = ratio(7, 8);
  for (const double x : {0.875, 0.8, 0.6}) {
    const Answer got = answer(bridged({e, e, e, e}), shapes::box({-4, -4, -4}, {x, 4, 4}));
    ASSERT_EQ(condition_of(got), "I1") << x;
    EXPECT_EQ(std::get<InsideDefect>(got).bridge, 0u);
    EXPECT_EQ(std::get<InsideDefect>(got).message.substr(0, 32),
              "bridge 0 is not proved to miss t");
  }
  // Bridges are solids here, not surfaces.
  EXPECT_EQ(condition_of(answer(bridged({e, e, e, e}), with_bubble({0.75, 0.5, 0.5}, 0.0625))),
            "I1");
}

// PROVES MICRO-2.I3
TEST(MicroInside, PointsBehindVoidsAreOffTheBoxesOfBridges) {
  const Rational e = ratio(7, 8);
  const Answer beside = answer(bridged({e, e, e, e}), with_bubble({0.75, 0.125, 0.5}, 0.0625));
  ASSERT_EQ(condition_of(beside), "");
  EXPECT_EQ(std::get<InsideProof>(beside).voids[0].corner, 8);
  // Between a slanted end and the box of the bridge.
  EXPECT_EQ(condition_of(answer(bridged({ratio(5, 8), ratio(5, 8), e, e}),
                                with_bubble({0.84375, 0.3125, 0.5}, 0.015625))),
            "I3");
}

// A bridge may pass knots; they change nothing.
TEST(MicroInside, KnotsInTheWayOfABridgeDoNotMatter) {
  const Rational e = ratio(7, 8);
  Microstructure micro = bridged({e, e, e, e});
  const TriangleMesh mesh = shapes::box({-4, -4, -4}, {1, 4, 4});
  const Rational plain = *std::get<InsideProof>(answer(micro, mesh)).skin;
  for (std::size_t axis = 0; axis < 3; ++axis)
    micro.cage[0] = refine(micro.cage[0], axis, {axis == 0 ? ratio(3, 4) : ratio(1, 2)});
  micro.grids.clear();
  MicroGrid grid = make_micro_grid(micro.cage[0], 0, {2, 2, 2}).value();
  grid.breaks = {std::vector<Rational>{Rational(0), ratio(1, 2)},
                 std::vector<Rational>{Rational(0), ratio(1, 2), Rational(1)},
                 std::vector<Rational>{Rational(0), ratio(1, 2), Rational(1)}};
  grid.tiles = {1, 0, 0, 1};
  micro.grids.push_back(grid);
  const Answer got = answer(micro, mesh);
  ASSERT_EQ(condition_of(got), "");
  EXPECT_EQ(*std::get<InsideProof>(got).skin, plain);
}

TEST(MicroInside, TheWorkIsBounded) {
  const Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, inner_jack());
  const TriangleMesh near = with_bubble({0.0625, 0.0625, 0.0625}, 0.0546875);
  EXPECT_EQ(condition_of(answer(micro, near)), "");
  InsideLimits few;
  few.nodes = few.nodes_of_part = 0;
  Answer got = answer(micro, near, 1, few);
  ASSERT_EQ(condition_of(got), "I1");
  EXPECT_FALSE(std::get<InsideDefect>(got).patch.has_value());
  few = {};
  few.pairs = 1;
  got = answer(micro, near, 1, few);
  EXPECT_EQ(condition_of(got), "I1");
  EXPECT_NE(std::get<InsideDefect>(got).message.find("more than"), std::string::npos);
}

Box3d box_around(const std::vector<VVolume>& cage) {
  Box3d box = empty_box();
  for (const VVolume& cell : cage)
    for (std::size_t i = 0; i < cell.grid().count(); ++i) {
      Point3d p{};
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] = nearest_double(cell.component(static_cast<int>(c))[i]);
        if (cell.is_rational()) p[c] /= nearest_double(cell.component(3)[i]);
      }
      add(p, &box);
    }
  return box;
}
// The last corner of the last patch of each tile lies in the open box.
void expect_points_in(const Microstructure& micro, const Box3d& box) {
  for (const MicroGrid& grid : micro.grids)
    for (std::uint64_t c = 0; c < grid.tiles.size(); ++c) {
      if (grid.tiles[c] == 0) continue;
      const auto at = grid.shape().index_of(c);
      const TilePatch& patch = micro.tiles[grid.tiles[c] - 1u].patches.back();
      TilePoint x = points_at(patch, number_of(patch, grid.numbers_of(at))).back();
      for (std::size_t a = 0; a < 3; ++a) {
        const auto& breaks = grid.breaks[a];
        x[a] = breaks[at[a]] + (breaks[at[a] + 1] - breaks[at[a]]) * x[a];
      }
      const VVolume& cell = micro.cage[grid.volume];
      const auto p = evaluate(cell, x).value();
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational q = cell.is_rational() ? p[k] / p[3] : p[k];
        EXPECT_LT(Rational::from_double(box.lo[k]), q);
        EXPECT_LT(q, Rational::from_double(box.hi[k]));
      }
    }
}

// PROVES MICRO-2
// Random structures in random cages: a box around all of them holds them; what is proved to be inside is inside where
// points of the tiles tell; the answer does not depend on the number of threads.
TEST(MicroInside, RandomStructuresAreInsideOnlyIfTheirPointsAre) {
  Random random(8020);
  int num_inside = 0, num_outside = 0;
  for (int round = 0; round < 40; ++round) {
    const random_micro::Structure s = random_micro::Maker(random).make();
    SCOPED_TRACE(std::to_string(round) + ": " + s.description);
    Box3d box = box_around(s.micro.cage);
    // From larger than the cage to much smaller along each axis.
    const double share = 0.25 - 0.0625 * static_cast<double>(random.below(9));
    for (std::size_t a = 0; a < 3; ++a) {
      const double grow = (box.hi[a] - box.lo[a]) * share;
      box.lo[a] -= grow;
      box.hi[a] += grow;
    }
    const TriangleMesh mesh =
        shapes::box({box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]});
    const Answer got = answer(s.micro, mesh), again = answer(s.micro, mesh, 4);
    if (share > 0) {
      EXPECT_EQ(condition_of(got), "");
    }
    EXPECT_EQ(condition_of(again), condition_of(got));
    if (const auto* const defect = std::get_if<InsideDefect>(&got)) {
      ++num_outside;
      EXPECT_EQ(std::get<InsideDefect>(again).message, defect->message);
    } else {
      ++num_inside;
      expect_points_in(s.micro, box);
    }
  }
  EXPECT_GT(num_inside, 10);
  EXPECT_GT(num_outside, 5);
}

}  // namespace
}  // namespace veritope
