// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/dms/fast/fast_grid_internal.h"

namespace veritope::internal {

FastGrid::FastGrid(const std::vector<Box3d>& boxes) : all_(empty_box()) {
  for (const Box3d& b : boxes) all_ = hull(all_, b);
  double wanted = static_cast<double>(boxes.size()) * 3;
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
    if (is_small && fill(boxes, 64 * boxes.size() + 64)) return;
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

// With one cell the lists have one entry for each box.
bool FastGrid::fill(const std::vector<Box3d>& boxes, std::size_t limit) {
  const std::size_t cells = size_[0] * size_[1] * size_[2];
  const auto for_each_cell = [&](const Box3d& b, auto visit) {
    std::size_t lo[3], hi[3];
    for (std::size_t c = 0; c < 3; ++c) lo[c] = cell(b.lo[c], c), hi[c] = cell(b.hi[c], c);
    for (std::size_t x = lo[0]; x <= hi[0]; ++x)
      for (std::size_t y = lo[1]; y <= hi[1]; ++y)
        for (std::size_t z = lo[2]; z <= hi[2]; ++z) visit((x * size_[1] + y) * size_[2] + z);
  };
  std::vector<std::size_t> first(cells + 1, 0);
  std::size_t total = 0;
  for (const Box3d& b : boxes) {
    std::size_t here = 1;
    for (std::size_t c = 0; c < 3; ++c) here *= cell(b.hi[c], c) - cell(b.lo[c], c) + 1;
    total += here;
    if (total > limit) return false;
    for_each_cell(b, [&](std::size_t i) { ++first[i + 1]; });
  }
  for (std::size_t i = 0; i < cells; ++i) first[i + 1] += first[i];
  numbers_.resize(total);
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    for_each_cell(boxes[b],
                  [&](std::size_t i) { numbers_[next[i]++] = static_cast<std::uint32_t>(b); });
  first_ = std::move(first);
  return true;
}

std::span<const std::uint32_t> FastGrid::near(const Vec3d& p) const {
  const std::size_t i = (cell(p.x, 0) * size_[1] + cell(p.y, 1)) * size_[2] + cell(p.z, 2);
  return std::span(numbers_).subspan(first_[i], first_[i + 1] - first_[i]);
}

}  // namespace veritope::internal
