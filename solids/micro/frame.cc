// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/frame.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "solids/vmodel/v_model.h"

namespace veritope {
namespace {

// Blocks between grid lines, which are equal along all axes.
constexpr std::size_t kFrameBlocks = 7;
constexpr std::size_t kFrameMiddle = 3;
using BlockPlace = std::array<std::size_t, 3>;

bool is_end_of_ring(std::size_t i) { return i == 1 || i == 5; }
// A ring across an axis: in the middle along it, and at the border of the square of the blocks 1 to 5.
bool is_in_ring(const BlockPlace& at, std::size_t axis) {
  if (at[axis] != kFrameMiddle) return false;
  const auto others = v_face_axes(axis);
  for (std::size_t k = 0; k < 2; ++k)
    if (at[others[k]] < 1 || at[others[k]] > 5) return false;
  return is_end_of_ring(at[others[0]]) || is_end_of_ring(at[others[1]]);
}

class FrameMaker {
 public:
  explicit FrameMaker(const FrameShape& shape) : shape_(shape) {
    const Rational half = Rational(1) / Rational(2), one(1);
    const std::array<Rational, 3> low = {shape.margin, shape.margin + shape.bar,
                                         half - shape.bar / Rational(2)};
    lines_ = {Rational(0), low[0], low[1], low[2], one - low[2], one - low[1], one - low[0], one};
  }
  MicroTile make() {
    for (std::size_t i = 0; i < kFrameBlocks; ++i)
      for (std::size_t j = 0; j < kFrameBlocks; ++j)
        for (std::size_t k = 0; k < kFrameBlocks; ++k)
          if (is_full({i, j, k})) add_block({i, j, k});
    return std::move(tile_);
  }

 private:
  bool is_full(const BlockPlace& at) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_in_ring(at, axis)) return true;
      const auto others = v_face_axes(axis);
      const bool is_end = at[axis] == 0 || at[axis] == kFrameBlocks - 1;
      if (!is_end || at[others[0]] != kFrameMiddle || at[others[1]] != kFrameMiddle) continue;
      return (shape_.arms >> (2 * axis + (at[axis] == 0 ? 0 : 1)) & 1) != 0;
    }
    return false;
  }
  void add_block(const BlockPlace& at) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const bool is_at_wall = at[axis] == (end == 0 ? 0 : kFrameBlocks - 1);
        BlockPlace beside = at;
        beside[axis] = end == 0 ? at[axis] - 1 : at[axis] + 1;
        if (is_at_wall || !is_full(beside)) add_face(at, axis, end);
      }
  }
  // The normal of a patch whose parameters run along the axes a + 1 and a + 2 points along a.
  void add_face(const BlockPlace& at, std::size_t axis, std::size_t end) {
    const std::size_t first = (axis + (end == 1 ? 1 : 2)) % 3,
                      second = (axis + (end == 1 ? 2 : 1)) % 3;
    TilePatch patch;
    auto& points = patch.points.emplace_back();
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
      for (const std::size_t j : {std::size_t{0}, std::size_t{1}}) {
        TilePoint& p = points.emplace_back();
        p[axis] = lines_[at[axis] + end];
        p[first] = lines_[at[first] + i];
        p[second] = lines_[at[second] + j];
      }
    tile_.patches.push_back(std::move(patch));
  }

  const FrameShape& shape_;
  std::array<Rational, kFrameBlocks + 1> lines_;
  MicroTile tile_;
};

}  // namespace

Result<MicroTile> frame_tile(const FrameShape& shape) {
  const Rational zero(0), two(2);
  if (!(zero < shape.bar) || !(zero < shape.margin) ||
      !(two * shape.margin + Rational(3) * shape.bar < Rational(1)))
    return bad_argument("bar = " + shape.bar.to_string() +
                        " and margin = " + shape.margin.to_string() +
                        " of a frame must be positive, and 2 margin + 3 bar less than 1");
  if (shape.arms > 63)
    return bad_argument("arms = " + std::to_string(shape.arms) + " of a frame is not 0 to 63");
  MicroTile tile = FrameMaker(shape).make();
  tile.name = "frame,bar=" + shape.bar.to_string() + ",margin=" + shape.margin.to_string();
  if (shape.arms != 63) tile.name += ",arms=" + std::to_string(shape.arms);
  return tile;
}

}  // namespace veritope
