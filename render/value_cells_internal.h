// SPDX-License-Identifier: LGPL-3.0-or-later
// render/value_cells_internal.h: a box cut into cells on which a solid has a value, or which are small.
#pragma once
#include <cstdint>
#include <vector>

#include "render/solid_probe.h"
#include "robust/base/work_share.h"

namespace veritope::internal {

/// A piece of a ray, from t = begin to t = end, in one cell.
struct RayPiece {
  double begin = 0, end = 0;
  Value3 value = Value3::kMixed;
};

/// origin + t * step.
struct ParametricRay {
  Point3d origin{}, step{};
  Vec3d at(double t) const {
    return {origin[0] + t * step[0], origin[1] + t * step[1], origin[2] + t * step[2]};
  }
};

/// A binary tree: cells whose value is mixed are halved along their longest side until it is at most `least_side`.
class ValueCells {
 public:
  /// Keeps no reference. The cells do not depend on `jobs`. At most kMostCells; the last levels are left out then.
  /// REQUIRES a finite box that is not empty; least_side at least 2^-30 of its longest side.
  ValueCells(const SolidProbe& solid, const Box3d& box, double least_side, unsigned jobs,
             WorkShare* work);
  static constexpr std::size_t kMostCells = std::size_t{1} << 25;

  const Box3d& box() const { return box_; }
  std::size_t num_cells() const { return cells_.size(); }
  /// The uncut cells that are not 0.
  std::vector<Box3d> solid_boxes() const;

  /// The part of the ray in the box: begin > end if it misses.
  RayPiece clipped(const ParametricRay& ray) const;
  /// Calls visit(piece) for the cells along the ray that are not 0, in their order, until it returns true; whether it
  /// did. Pieces may be points.
  template <typename Visit>
  bool walk(const ParametricRay& ray, Visit&& visit) const;

 private:
  // A cut cell has the number of its first half; the second one follows it.
  struct Cell {
    std::uint32_t half = 0;
    std::uint8_t axis = 0;
    Value3 value = Value3::kMixed;
    double middle = 0;
  };
  struct Visit {
    std::uint32_t cell;
    double begin, end;
  };

  Box3d box_;
  std::vector<Cell> cells_;
};

template <typename Call>
bool ValueCells::walk(const ParametricRay& ray, Call&& call) const {
  const RayPiece all = clipped(ray);
  if (!(all.begin <= all.end)) return false;
  constexpr std::size_t kDeepest = 128;  // one a level: sides of doubles are halved 42 times each
  std::array<Visit, kDeepest> waiting;
  std::size_t num = 0;
  waiting[num++] = {0, all.begin, all.end};
  while (num > 0) {
    const auto [at, begin, end] = waiting[--num];
    const Cell& cell = cells_[at];
    if (cell.value == Value3::kZero) continue;
    if (cell.half == 0) {
      if (call(RayPiece{begin, end, cell.value})) return true;
      continue;
    }
    const double step = ray.step[cell.axis], origin = ray.origin[cell.axis];
    const std::uint32_t first =
                            cell.half + (step < 0 || (step == 0 && cell.middle < origin) ? 1 : 0),
                        second = 2 * cell.half + 1 - first;
    const double cut = step == 0 ? end : (cell.middle - origin) / step;
    if (cut < end) waiting[num++] = {second, cut < begin ? begin : cut, end};
    if (begin <= cut) waiting[num++] = {first, begin, cut < end ? cut : end};
  }
  return false;
}

}  // namespace veritope::internal
