// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/tile_certifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>

#include "robust/base/random.h"
#include "solids/micro/bifurcation.h"
#include "solids/micro/frame.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using micro_cells::at;
using micro_cells::box_tile;
using micro_cells::square;

std::string code_of(const MicroTile& tile) {
  const auto found = star_boxes_of(tile);
  const auto* const finding = std::get_if<Finding>(&found);
  return finding != nullptr ? finding->code : "";
}
MicroTile joined(MicroTile a, const MicroTile& b) {
  a.patches.insert(a.patches.end(), b.patches.begin(), b.patches.end());
  return a;
}
MicroTile inside_out(MicroTile tile) {
  for (TilePatch& p : tile.patches) std::swap(p.points[0][1], p.points[0][2]);
  return tile;
}

// PROVES MICRO-1.F3
TEST(TileCertifier, ProvesTilesThatAreNoStars) {
  JackShape bent;
  bent.arms = 31;
  for (const MicroTile& tile : {frame_tile({}).value(), bifurcation_tile(bent).value(),
                                jack_tile({}).value(), box_tile({16, 16, 0}, {48, 48, 64})}) {
    const auto found = star_boxes_of(tile);
    ASSERT_TRUE(std::holds_alternative<certificate::StarBoxBody>(found)) << tile.name;
    const auto& body = std::get<certificate::StarBoxBody>(found);
    EXPECT_EQ(body.version, 2);
    ASSERT_EQ(body.entities.size(), tile.patches.size());
    for (const certificate::PatchEntity& e : body.entities) {
      EXPECT_TRUE(e.is_surface);
      EXPECT_FALSE(e.is_reversed);
      EXPECT_EQ(e.breaks[0].size(), 2u);
      EXPECT_EQ(e.breaks[1].size(), 2u);
    }
    EXPECT_FALSE(certificate::encode(body).empty());
  }
}

// PROVES MICRO-1.F3
TEST(TileCertifier, RefusesWhatIsNotOneSolid) {
  const MicroTile box = box_tile({8, 8, 8}, {32, 32, 32});
  EXPECT_EQ(code_of(inside_out(box)), "inside-out");
  EXPECT_EQ(code_of(joined(box, box_tile({40, 40, 40}, {48, 48, 48}))), "several-shells");
  // A cavity: one body, two shells.
  EXPECT_EQ(code_of(joined(box, inside_out(box_tile({16, 16, 16}, {24, 24, 24})))),
            "several-shells");
  EXPECT_EQ(code_of(joined(box, box_tile({20, 20, 20}, {48, 48, 48}))), "patches-crossing");
  MicroTile open = box;
  open.patches.pop_back();
  EXPECT_EQ(code_of(open), "side-open");
  MicroTile twice = box;
  twice.patches.push_back(box.patches.front());
  EXPECT_NE(code_of(twice), "");
}

// Unions of unit cubes of a grid, with the truth about their surfaces by looking at all corners of cubes.
class Cubes {
 public:
  static constexpr int kSide = 5;  // the outermost cubes are empty

  Cubes(Random& random, int percent) {
    for (int i = 1; i + 1 < kSide; ++i)
      for (int j = 1; j + 1 < kSide; ++j)
        for (int k = 1; k + 1 < kSide; ++k)
          full_[index({i, j, k})] = static_cast<int>(random.below(100)) < percent;
  }
  bool is_one_solid() const {
    if (count_parts(all(), true) != 1 || count_parts(all(), false) != 1) return false;
    for (int i = 1; i < kSide; ++i)
      for (int j = 1; j < kSide; ++j)
        for (int k = 1; k < kSide; ++k)
          if (count_parts(around(i, j, k), true) > 1 || count_parts(around(i, j, k), false) > 1)
            return false;
    return true;
  }
  MicroTile surface() const {
    MicroTile out;
    for (const Place& p : all())
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int end : {0, 1}) {
          Place beside = p;
          beside[axis] += 2 * end - 1;
          if (is_full(p) && !is_full(beside)) out.patches.push_back(face(p, axis, end));
        }
    return out;
  }
  std::string text() const {
    std::string out;
    for (const bool b : full_) out += b ? '1' : '0';
    return out;
  }

 private:
  using Place = std::array<int, 3>;
  static std::size_t index(const Place& p) {
    return static_cast<std::size_t>((p[0] * kSide + p[1]) * kSide + p[2]);
  }
  bool is_full(const Place& p) const { return full_[index(p)]; }
  static std::vector<Place> all() { return box({0, 0, 0}, kSide); }
  static std::vector<Place> around(int i, int j, int k) { return box({i - 1, j - 1, k - 1}, 2); }
  static std::vector<Place> box(const Place& low, int side) {
    std::vector<Place> out;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
        for (int k = 0; k < side; ++k) out.push_back({low[0] + i, low[1] + j, low[2] + k});
    return out;
  }
  // Counts the parts of the full, or of the empty, cubes among these; parts hang together by faces.
  int count_parts(const std::vector<Place>& places, bool full) const {
    std::vector<Place> left;
    for (const Place& p : places)
      if (is_full(p) == full) left.push_back(p);
    int parts = 0;
    while (!left.empty()) {
      ++parts;
      std::vector<Place> stack = {left.back()};
      left.pop_back();
      while (!stack.empty()) {
        const Place p = stack.back();
        stack.pop_back();
        const auto is_beside = [&p](const Place& q) {
          return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) == 1;
        };
        std::copy_if(left.begin(), left.end(), std::back_inserter(stack), is_beside);
        std::erase_if(left, is_beside);
      }
    }
    return parts;
  }
  static TilePatch face(const Place& p, std::size_t axis, int end) {
    const std::size_t first = (axis + (end == 1 ? 1 : 2)) % 3,
                      second = (axis + (end == 1 ? 2 : 1)) % 3;
    std::array<TilePoint, 4> c;
    constexpr std::array<std::array<int, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      Place q = p;
      q[axis] += end;
      q[first] += kCorners[i][0];
      q[second] += kCorners[i][1];
      c[i] = at(8 * q[0] + 8, 8 * q[1] + 8, 8 * q[2] + 8);
    }
    return square(c[0], c[1], c[2], c[3]);
  }

  std::array<bool, static_cast<std::size_t>(kSide* kSide* kSide)> full_{};
};

// PROVES MICRO-1.F3
TEST(TileCertifier, AUnionOfCubesIsProvedIffItIsOneSolid) {
  Random random(4711);
  int num_solids = 0, num_others = 0;
  for (int round = 0; round < 400; ++round) {
    const Cubes cubes(random, 40 + static_cast<int>(random.below(55)));
    const MicroTile tile = cubes.surface();
    if (tile.patches.empty()) continue;
    const bool is_solid = cubes.is_one_solid();
    ++(is_solid ? num_solids : num_others);
    EXPECT_EQ(code_of(tile).empty(), is_solid) << cubes.text() << " " << code_of(tile);
  }
  EXPECT_GT(num_solids, 30);
  EXPECT_GT(num_others, 100);
}

TEST(TileCertifier, BudgetsOfBoxesAreKept) {
  CertifyOptions options;
  options.max_cells = 3;
  const auto found = star_boxes_of(frame_tile({}).value(), options);
  ASSERT_TRUE(std::holds_alternative<Finding>(found));
  EXPECT_EQ(std::get<Finding>(found).code, "cell-limit");
}

}  // namespace
}  // namespace veritope
