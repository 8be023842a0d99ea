// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "solids/micro/bifurcation.h"
#include "solids/micro/frame.h"
#include "solids/micro/tile_analysis.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using micro_cells::at;
using micro_cells::box_tile;
using micro_cells::square;

AnalysedTile analysed(const MicroTile& tile) {
  auto result = analyse_tile(tile);
  if (const auto* defect = std::get_if<TileDefect>(&result)) {
    ADD_FAILURE() << defect->condition << ": " << defect->message;
    return {};
  }
  return std::get<AnalysedTile>(std::move(result));
}
std::string condition_of(const MicroTile& tile) {
  const auto result = analyse_tile(tile);
  const auto* defect = std::get_if<TileDefect>(&result);
  if (defect == nullptr) defect = std::get_if<TileDefect>(&std::get<AnalysedTile>(result).star);
  return defect != nullptr ? defect->condition : "";
}
TilePoint centre_of(const MicroTile& tile) {
  return std::get<TileStar>(analysed(tile).star).centre;
}
MicroTile jack(JackShape shape = {}) { return jack_tile(shape).value(); }

TEST(Jack, HasFourPatchesAndACapForEachArm) {
  for (const int degree : {1, 3}) {
    JackShape shape;
    shape.degree = degree;
    const AnalysedTile tile = analysed(jack(shape));
    EXPECT_EQ(tile.tile.patches.size(), 30u);
    EXPECT_EQ(tile.surface.num_vertices, 32u);
    EXPECT_EQ(tile.surface.num_edges, 60u);
    EXPECT_EQ(tile.surface.euler(), 2);
    ASSERT_EQ(tile.caps.size(), 6u);
    for (int wall = 0; wall < 6; ++wall) {
      EXPECT_EQ(tile.caps[static_cast<std::size_t>(wall)].wall, wall);
      EXPECT_EQ(tile.caps[static_cast<std::size_t>(wall)].euler, 1);
    }
  }
}

TEST(Jack, IsAStarForEveryNumberOfItsRange) {
  JackShape shape;
  shape.degree = 1;
  shape.range = {{1, kMaxWallNumber / 2 - 1}};
  const AnalysedTile tile = analysed(jack(shape));
  EXPECT_EQ(centre_of(tile.tile), (TilePoint{Rational(1) / Rational(2), Rational(1) / Rational(2),
                                             Rational(1) / Rational(2)}));
  EXPECT_EQ(tile.tile.range, shape.range);
}

TEST(Jack, CubicArmsThatWidenTooFastAreNotProvedStars) {
  JackShape shape;
  shape.node = Rational(1) / Rational(20);
  shape.cap = Rational(9) / Rational(20);
  EXPECT_EQ(condition_of(jack(shape)), "F1");
  shape.degree = 1;
  EXPECT_EQ(condition_of(jack(shape)), "");
}

TEST(Jack, IsClosedWhereAnArmIsLeftOut) {
  for (unsigned arms = 1; arms < 64; ++arms) {
    JackShape shape;
    shape.arms = arms;
    const AnalysedTile tile = analysed(jack(shape));
    for (std::size_t wall = 0; wall < 6; ++wall)
      EXPECT_EQ(tile.caps_of_wall[wall].size(), arms >> wall & 1u) << arms;
  }
  JackShape none;
  none.arms = 0;
  EXPECT_TRUE(analysed(jack(none)).caps.empty());
}

TEST(Jack, RefusesNumbersOutsideOfTheirRanges) {
  const auto code = [](const JackShape& shape) {
    const auto tile = jack_tile(shape);
    return tile ? "" : code_name(tile.error().code);
  };
  JackShape shape;
  for (const Rational& bad : {Rational(0), Rational(1) / Rational(2), Rational(-1)}) {
    shape.node = bad;
    EXPECT_STREQ(code(shape), "bad-argument");
    shape = {};
    shape.cap = bad;
    EXPECT_STREQ(code(shape), "bad-argument");
    shape = {};
  }
  for (const int degree : {0, 2, 4}) {
    shape.degree = degree;
    EXPECT_STREQ(code(shape), "bad-argument");
  }
  shape = {};
  shape.arms = 64;
  EXPECT_STREQ(code(shape), "bad-argument");
  shape = {};
  for (const auto& range : {std::array<std::int32_t, 2>{0, 5}, {6, 5}, {5, kMaxWallNumber / 2}}) {
    shape.range = range;
    EXPECT_STREQ(code(shape), "bad-argument");
  }
}

TEST(Frame, IsThreeRingsWithStubs) {
  for (const unsigned arms : {63u, 0u, 1u, 36u}) {
    FrameShape shape;
    shape.arms = arms;
    const AnalysedTile tile = analysed(frame_tile(shape).value());
    EXPECT_EQ(tile.surface.euler(), 2 - 2 * 7);
    EXPECT_FALSE(tile.is_star());
    for (std::size_t wall = 0; wall < 6; ++wall)
      EXPECT_EQ(tile.caps_of_wall[wall].size(), arms >> wall & 1u);
    for (const TileCap& cap : tile.caps) EXPECT_EQ(cap.patches.size(), 1u);
    EXPECT_EQ(shells_without(tile, (1u << tile.caps.size()) - 1).count, 1u);
  }
}
TEST(Frame, RefusesBarsThatLeaveNoWindow) {
  FrameShape shape;
  shape.bar = Rational(2) / Rational(9);  // 2/6 + 6/9 = 1
  EXPECT_EQ(frame_tile(shape).error().code, Code::kBadArgument);
  shape.bar = Rational(0);
  EXPECT_EQ(frame_tile(shape).error().code, Code::kBadArgument);
  shape = {};
  shape.margin = Rational(0);
  EXPECT_EQ(frame_tile(shape).error().code, Code::kBadArgument);
  shape = {};
  shape.arms = 64;
  EXPECT_EQ(frame_tile(shape).error().code, Code::kBadArgument);
}

JackShape bifurcation(int degree, unsigned arms = 31) {
  JackShape shape;
  shape.degree = degree;
  shape.arms = arms;
  return shape;
}
TEST(Bifurcation, HasFourCapsOnTopAndIsAStarIfItIsStraight) {
  for (const int degree : {1, 3})
    for (const unsigned arms : {31u, 0u, 16u, 5u}) {
      const AnalysedTile tile = analysed(bifurcation_tile(bifurcation(degree, arms)).value());
      EXPECT_EQ(tile.surface.euler(), 2);
      EXPECT_EQ(tile.is_star(), degree == 1) << arms;
      for (std::size_t wall = 0; wall < 5; ++wall)
        EXPECT_EQ(tile.caps_of_wall[wall].size(), arms >> wall & 1u);
      EXPECT_EQ(tile.caps_of_wall[5].size(), 4u);
    }
}
TEST(Bifurcation, IsAStarForEveryNumberOfItsRange) {
  JackShape shape = bifurcation(1);
  shape.range = {{kMaxWallNumber / 16, kMaxWallNumber / 4}};
  EXPECT_TRUE(analysed(bifurcation_tile(shape).value()).is_star());
  shape.degree = 3;
  EXPECT_TRUE(analysed(bifurcation_tile(shape).value()).is_star());
}
TEST(Bifurcation, RefusesAnArmToItsTop) {
  EXPECT_EQ(bifurcation_tile(bifurcation(1, 63)).error().code, Code::kBadArgument);
  EXPECT_EQ(bifurcation_tile(bifurcation(2)).error().code, Code::kBadArgument);
}

TEST(TileAnalysis, ABoxBetweenTwoWallsHasTwoCaps) {
  const AnalysedTile tile = analysed(box_tile({16, 16, 0}, {48, 48, 64}));
  EXPECT_EQ(tile.caps.size(), 2u);
  EXPECT_EQ(tile.caps_of_wall[4].size(), 1u);
  EXPECT_EQ(tile.caps_of_wall[5].size(), 1u);
  EXPECT_EQ(shells_without(tile, 0).count, 1u);
  EXPECT_EQ(shells_without(tile, 3).count, 1u);
}

TEST(TileAnalysis, CentresHaveNumbersThatACertificateMayHave) {
  // Off the middle of the cube: its centre lies straight behind the middle of a side.
  MicroTile tile = box_tile({2, 2, 0}, {10, 10, 64});
  EXPECT_EQ(centre_of(tile), at(8, 6, 32));
  const Rational shift = Rational(1) / Rational(power_of_two(100) + Integer(1));
  for (TilePatch& patch : tile.patches)
    for (TilePoint& p : patch.points[0]) p[0] += shift, p[1] += shift;
  EXPECT_EQ(condition_of(tile), "F1");
}

// PROVES MICRO-1.S0
TEST(TileAnalysis, RefusesSurfacesThatAreNotClosed) {
  MicroTile tile = box_tile({16, 16, 0}, {48, 48, 64});
  MicroTile open = tile;
  open.patches.pop_back();
  EXPECT_EQ(condition_of(open), "S0");
  MicroTile twice = tile;
  twice.patches.push_back(tile.patches[2]);
  EXPECT_EQ(condition_of(twice), "S0");
  MicroTile inward = tile;
  std::swap(inward.patches[0].points[0][1], inward.patches[0].points[0][2]);
  EXPECT_EQ(condition_of(inward), "S0");
}
// PROVES MICRO-1.F1
TEST(TileAnalysis, RefusesATileThatIsInsideOut) {
  MicroTile tile = box_tile({16, 16, 0}, {48, 48, 64});
  for (TilePatch& p : tile.patches) std::swap(p.points[0][1], p.points[0][2]);
  EXPECT_EQ(condition_of(tile), "F1");
}
// A bipyramid whose equator winds around its axis twice: each triangle, a square with a collapsed side, turns around the
// centre, and the surface is closed, but it covers each direction twice.
// PROVES MICRO-1.F2
TEST(TileAnalysis, RefusesASurfaceThatWindsTwice) {
  MicroTile tile;
  const std::array<std::array<int, 2>, 3> ring = {{{48, 32}, {20, 46}, {20, 18}}};
  // The second turn has other radii, so that no two sides are equal.
  const std::array<std::array<int, 2>, 3> outer = {{{56, 32}, {16, 52}, {16, 12}}};
  std::vector<TilePoint> equator;
  for (const auto& turn : {ring, outer})
    for (const auto& p : turn) equator.push_back(at(p[0], p[1], 32));
  const TilePoint top = at(32, 32, 60), bottom = at(32, 32, 4);
  for (std::size_t i = 0; i < 6; ++i) {
    const TilePoint &a = equator[i], &b = equator[(i + 1) % 6];
    tile.patches.push_back(square(a, b, top, top));
    tile.patches.push_back(square(b, a, bottom, bottom));
  }
  EXPECT_TRUE(std::holds_alternative<TileSurface>(surface_of(tile)));
  EXPECT_EQ(condition_of(tile), "F2");
}
// PROVES MICRO-1.T2
TEST(TileAnalysis, RefusesWhatTouchesAWallOffItsCaps) {
  EXPECT_EQ(condition_of(box_tile({0, 16, 0}, {48, 48, 64})), "T2");    // two caps with one edge
  EXPECT_EQ(condition_of(box_tile({16, 16, -1}, {48, 48, 64})), "T2");  // out of the cube
  // The tile reaches wall z = 0 with an edge, a corner.
  MicroTile keel = box_tile({16, 16, 8}, {48, 48, 64});
  for (TilePatch& p : keel.patches)
    for (TilePoint& q : p.points[0])
      if (q[2] == at(0, 0, 8)[2] && q[0] == at(16, 0, 0)[0]) q[2] = Rational(0);
  EXPECT_EQ(condition_of(keel), "T2");
  MicroTile corner = box_tile({16, 16, 8}, {48, 48, 64});
  for (TilePatch& p : corner.patches)
    for (TilePoint& q : p.points[0])
      if (q == at(16, 16, 8)) q[2] = Rational(0);
  EXPECT_EQ(condition_of(corner), "T2");
}

// Two squares in a wall that meet in a corner, each with a box that widens to a common block behind.
// PROVES MICRO-1.T3
TEST(TileAnalysis, RefusesCapsOfOneWallThatMeetInACorner) {
  // Each corner of the block z = 16 is drawn to the wall; the caps are the squares [16,32]^2 and [32,48]^2.
  MicroTile tile;
  std::array<std::array<TilePoint, 3>, 3> low, rim;  // of the wall; of the level above it
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const bool is_notch = (i == 0 && j == 2) || (i == 2 && j == 0);
      low[a][b] = at(16 + 16 * i, 16 + 16 * j, is_notch ? 8 : 0);
      rim[a][b] = at(16 + 16 * i, 16 + 16 * j, 64);
    }
  const auto bottom = [&](std::size_t i, std::size_t j) {
    tile.patches.push_back(square(low[i][j], low[i][j + 1], low[i + 1][j + 1], low[i + 1][j]));
    tile.patches.push_back(square(rim[i][j], rim[i + 1][j], rim[i + 1][j + 1], rim[i][j + 1]));
  };
  for (const std::size_t i : {0u, 1u})
    for (const std::size_t j : {0u, 1u}) bottom(i, j);
  for (const std::size_t k : {0u, 1u}) {
    tile.patches.push_back(square(low[k][0], low[k + 1][0], rim[k + 1][0], rim[k][0]));
    tile.patches.push_back(square(low[k + 1][2], low[k][2], rim[k][2], rim[k + 1][2]));
    tile.patches.push_back(square(low[0][k + 1], low[0][k], rim[0][k], rim[0][k + 1]));
    tile.patches.push_back(square(low[2][k], low[2][k + 1], rim[2][k + 1], rim[2][k]));
  }
  EXPECT_EQ(condition_of(tile), "T3");
}

}  // namespace
}  // namespace veritope
