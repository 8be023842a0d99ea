// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/dms/fast/fast_grid_internal.h"

namespace veritope::internal {

namespace {

// The outer sides of the four faces of a tetrahedron, with a margin far above all rounding errors.
class FastFaces {
 public:
  FastFaces(const std::array<Point3d, 4>& corners, const Box3d& box, double cell_side)
      : corners_(corners) {
    double size = extent(box) + 2 * cell_side;
    for (std::size_t c = 0; c < 3; ++c)
      size = std::max(size, 0x1p-10 * std::max(std::abs(box.lo[c]), std::abs(box.hi[c])));
    size *= 2;
    margin_ = size * size * size * 0x1p-30;
    constexpr std::size_t kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    for (std::size_t m = 0; m < 4; ++m) {
      Point3d a, b;
      for (std::size_t c = 0; c < 3; ++c) {
        a[c] = corners[kFaces[m][1]][c] - corners[kFaces[m][0]][c];
        b[c] = corners[kFaces[m][2]][c] - corners[kFaces[m][0]][c];
      }
      normal_[m] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0]};
    }
  }
  // Whether the box is on the outer side of a face. False where numbers overflow.
  bool are_apart_from(const Box3d& box) const {
    for (std::size_t m = 0; m < 4; ++m) {
      const Point3d& on = corners_[m == 0 ? 1 : 0];
      double least = 0;
      for (std::size_t c = 0; c < 3; ++c)
        least += normal_[m][c] * ((normal_[m][c] > 0 ? box.lo[c] : box.hi[c]) - on[c]);
      if (least > margin_) return true;
    }
    return false;
  }

 private:
  const std::array<Point3d, 4>& corners_;
  std::array<Point3d, 4> normal_;  // outward if the orientation is positive
  double margin_;
};

}  // namespace

FastGrid::FastGrid(const std::vector<Box3d>& boxes,
                   const std::vector<std::array<Point3d, 4>>& corners)
    : all_(empty_box()) {
  for (const Box3d& b : boxes) all_ = hull(all_, b);
  double wanted = static_cast<double>(boxes.size()) * 8;
  while (true) {
    // Cells are cubes, nearly: as many as wanted, at most 2^20 along an axis.
    double volume = 1, least = extent(all_) * 0x1p-20;
    for (std::size_t c = 0; c < 3; ++c) volume *= std::max(all_.hi[c] - all_.lo[c], least);
    const double side = std::cbrt(volume / std::max(wanted, 1.0));
    for (std::size_t c = 0; c < 3; ++c) {
      const double length = all_.hi[c] - all_.lo[c];
      const double count = wanted > 1 && side > 0 && std::isfinite(side) ? length / side : 1;
      size_[c] = static_cast<std::size_t>(std::clamp(std::floor(count), 1.0, 0x1p20));
      per_cell_[c] = length > 0 ? static_cast<double>(size_[c]) / length : 0;
      if (!std::isfinite(per_cell_[c])) per_cell_[c] = 0;
    }
    const bool is_small = size_[0] * size_[1] * size_[2] <= 16 * boxes.size() + 64;
    if (is_small && fill(boxes, corners, 64 * boxes.size() + 64)) return;
    wanted /= 4;
  }
}

// A monotone function of x, so that a point of a box lies in a cell between those of the box's ends.
std::size_t FastGrid::cell(double x, std::size_t axis) const {
  const double at = (x - all_.lo[axis]) * per_cell_[axis];
  if (!(at > 0)) return 0;
  const auto last = static_cast<double>(size_[axis] - 1);
  return static_cast<std::size_t>(std::min(at, last));
}

// All points that the function above puts into the cell, and some more: it is off by a few roundings of the grid's
// size.
Box3d FastGrid::cell_box(const std::array<std::size_t, 3>& at) const {
  Box3d out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double length = all_.hi[c] - all_.lo[c], side = length / static_cast<double>(size_[c]);
    const double slack = 0x1p-40 * (length + std::max(std::abs(all_.lo[c]), std::abs(all_.hi[c])));
    out.lo[c] = all_.lo[c] + side * static_cast<double>(at[c]) - slack;
    out.hi[c] = all_.lo[c] + side * static_cast<double>(at[c] + 1) + slack;
    if (per_cell_[c] == 0) out.lo[c] = all_.lo[c], out.hi[c] = all_.hi[c];
  }
  return out;
}

// With one cell the lists have one entry for each box, at most.
bool FastGrid::fill(const std::vector<Box3d>& boxes,
                    const std::vector<std::array<Point3d, 4>>& corners, std::size_t limit) {
  const std::size_t cells = size_[0] * size_[1] * size_[2];
  double side = 0;
  for (std::size_t c = 0; c < 3; ++c)
    side = std::max(side, (all_.hi[c] - all_.lo[c]) / static_cast<double>(size_[c]));
  const auto for_each_cell = [&](std::size_t number, auto visit) {
    const Box3d& b = boxes[number];
    const FastFaces faces(corners[number], b, side);
    std::array<std::size_t, 3> lo, hi, at;
    for (std::size_t c = 0; c < 3; ++c) lo[c] = cell(b.lo[c], c), hi[c] = cell(b.hi[c], c);
    for (at[0] = lo[0]; at[0] <= hi[0]; ++at[0])
      for (at[1] = lo[1]; at[1] <= hi[1]; ++at[1])
        for (at[2] = lo[2]; at[2] <= hi[2]; ++at[2])
          if (!faces.are_apart_from(cell_box(at)))
            visit((at[0] * size_[1] + at[1]) * size_[2] + at[2]);
  };
  std::vector<std::size_t> first(cells + 1, 0);
  std::size_t total = 0;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    std::size_t here = 1;
    for (std::size_t c = 0; c < 3; ++c)
      here *= cell(boxes[b].hi[c], c) - cell(boxes[b].lo[c], c) + 1;
    total += here;
    if (total > limit) return false;
    for_each_cell(b, [&](std::size_t i) { ++first[i + 1]; });
  }
  for (std::size_t i = 0; i < cells; ++i) first[i + 1] += first[i];
  numbers_.resize(first[cells]);
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    for_each_cell(b, [&](std::size_t i) { numbers_[next[i]++] = static_cast<std::uint32_t>(b); });
  first_ = std::move(first);
  return true;
}

std::span<const std::uint32_t> FastGrid::near(const Vec3d& p) const {
  const std::size_t i = (cell(p.x, 0) * size_[1] + cell(p.y, 1)) * size_[2] + cell(p.z, 2);
  return std::span(numbers_).subspan(first_[i], first_[i + 1] - first_[i]);
}

}  // namespace veritope::internal
