// SPDX-License-Identifier: LGPL-3.0-or-later
// render/point_grid.h: a regular grid of points, each with what is known of it, as in figures 13 to 19 of seed 001
// [GRF03].
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "interval/exact_box.h"
#include "render/solid_probe.h"
#include "robust/base/work_share.h"

namespace veritope {

inline constexpr std::uint32_t kMostGridSide = 1024;

/// What a picture shows at a point of a grid.
enum class GridMark : std::uint8_t {
  kNone,       ///< nothing: the point is off
  kIn,         ///< a ball
  kOn,         ///< a ball of another colour
  kUndecided,  ///< likewise
  kExcess      ///< red: a point of a subset of a chain that is not in the result
};

/// The n^3 points lo + (2 i + 1) / (2 n) (hi - lo), coordinate by coordinate, of a box; i, j, k from 0 to n - 1.
class PointGrid {
 public:
  /// All points are kNone. REQUIRES sides of positive length, 1 <= n <= kMostGridSide.
  PointGrid(ExactBox<3> bounds, std::uint32_t n);

  const ExactBox<3>& bounds() const { return bounds_; }
  std::uint32_t n() const { return n_; }
  Rational coordinate(std::size_t axis, std::uint32_t i) const;
  ExactPoint point(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return {coordinate(0, i), coordinate(1, j), coordinate(2, k)};
  }

  GridMark mark(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const Block& block = blocks_[block_of(i, j, k)];
    return block.marks.empty() ? block.all : block.marks[place_of(i, j, k)];
  }
  void set(std::uint32_t i, std::uint32_t j, std::uint32_t k, GridMark mark);
  std::uint64_t count(GridMark mark) const;

 private:
  friend class GridFiller;
  static constexpr std::uint32_t kSide = 32;
  struct Block {
    GridMark all = GridMark::kNone;  ///< of each point, if `marks` is empty
    std::vector<GridMark> marks;
  };
  std::size_t block_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return (std::size_t{i / kSide} * num_ + j / kSide) * num_ + k / kSide;
  }
  static std::size_t place_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return (std::size_t{i % kSide} * kSide + j % kSide) * kSide + k % kSide;
  }
  /// The points of a block along one axis: [first, last).
  std::array<std::uint32_t, 2> range(std::size_t number) const;

  ExactBox<3> bounds_;
  std::uint32_t n_, num_;  ///< points and blocks along each axis
  std::vector<Block> blocks_;
};

/// The exact words of all points of a grid. Blocks of points on whose box the solid has a value are not asked one by
/// one. The result does not depend on `jobs`. REQUIRES bounds and n as PointGrid does.
PointGrid classify_grid(const SolidProbe& solid, const ExactBox<3>& bounds, std::uint32_t n,
                        unsigned jobs, WorkShare* work = nullptr);

}  // namespace veritope
