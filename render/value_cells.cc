// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <utility>

#include "render/value_cells_internal.h"
#include "robust/base/parallel.h"

namespace veritope::internal {
namespace {

struct OpenCell {
  std::uint32_t number = 0;
  Box3d box;
};

}  // namespace

// Level by level, so that the numbers of cells do not depend on threads.
ValueCells::ValueCells(const SolidProbe& solid, const Box3d& box, double least_side, unsigned jobs,
                       WorkShare* work)
    : box_(box), cells_(1) {
  std::vector<OpenCell> level{{0, box}}, next;
  std::vector<Value3> values;
  while (!level.empty()) {
    WorkStep step(work, static_cast<double>(level.size()));
    values.resize(level.size());
    parallel_for(level.size(), 64, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) values[i] = solid.value(level[i].box);
      step.add(static_cast<double>(end - begin));
    });
    next.clear();
    const bool is_full = kMostCells - cells_.size() < 2 * level.size();
    for (std::size_t i = 0; i < level.size(); ++i) {
      cells_[level[i].number].value = values[i];
      if (values[i] == Value3::kZero) continue;
      const Box3d& whole = level[i].box;
      const std::size_t axis = longest_axis(whole);
      const double middle = 0.5 * whole.lo[axis] + 0.5 * whole.hi[axis];
      if (values[i] == Value3::kOne || is_full || extent(whole) <= least_side ||
          middle <= whole.lo[axis] || whole.hi[axis] <= middle)
        continue;
      Cell& cell = cells_[level[i].number];
      cell.half = static_cast<std::uint32_t>(cells_.size());
      cell.axis = static_cast<std::uint8_t>(axis);
      cell.middle = middle;
      Box3d low = whole, high = whole;
      low.hi[axis] = high.lo[axis] = middle;
      next.push_back({cells_[level[i].number].half, low});
      next.push_back({cells_[level[i].number].half + 1, high});
      cells_.resize(cells_.size() + 2);
    }
    std::swap(level, next);
  }
}

std::vector<Box3d> ValueCells::solid_boxes() const {
  std::vector<Box3d> out;
  std::vector<OpenCell> waiting{{0, box_}};
  while (!waiting.empty()) {
    const OpenCell at = waiting.back();
    waiting.pop_back();
    const Cell& cell = cells_[at.number];
    if (cell.value == Value3::kZero) continue;
    if (cell.half == 0) {
      out.push_back(at.box);
      continue;
    }
    OpenCell low{cell.half, at.box}, high{cell.half + 1, at.box};
    low.box.hi[cell.axis] = high.box.lo[cell.axis] = cell.middle;
    waiting.push_back(low), waiting.push_back(high);
  }
  return out;
}

RayPiece ValueCells::clipped(const ParametricRay& ray) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RayPiece out{-kInfinity, kInfinity};
  for (std::size_t k = 0; k < 3; ++k) {
    if (ray.step[k] == 0) {
      if (ray.origin[k] < box_.lo[k] || box_.hi[k] < ray.origin[k]) return {1, 0};
      continue;
    }
    const double a = (box_.lo[k] - ray.origin[k]) / ray.step[k],
                 b = (box_.hi[k] - ray.origin[k]) / ray.step[k];
    out.begin = std::max(out.begin, std::min(a, b));
    out.end = std::min(out.end, std::max(a, b));
  }
  return out;
}

}  // namespace veritope::internal
