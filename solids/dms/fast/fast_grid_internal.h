// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_grid_internal.h: which tetrahedra may contain a point: lists of a regular grid.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/box3d.h"

namespace veritope::internal {

/// Cells of a grid over the hull of boxes, with the numbers of the boxes that meet each cell, ascending. There are
/// approximately eight cells for each box; fewer, if the lists would have more than 64 entries for each box.
class FastGrid {
 public:
  /// REQUIRES finite boxes.
  explicit FastGrid(const std::vector<Box3d>& boxes);

  /// All boxes that contain the point are listed, ascending; others may be.
  std::span<const std::uint32_t> near(const Vec3d& p) const;

 private:
  bool fill(const std::vector<Box3d>& boxes, std::size_t limit);
  std::size_t cell(double x, std::size_t axis) const;

  Box3d all_;
  double per_cell_[3] = {0, 0, 0};
  std::size_t size_[3] = {1, 1, 1};
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace veritope::internal
