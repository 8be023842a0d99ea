// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_grid_internal.h: which tetrahedra may contain a point: lists of a regular grid.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/box3d.h"

namespace veritope::internal {

/// Cells of a grid over the hull of boxes, with the numbers of the tetrahedra that meet each cell, ascending. There are
/// approximately eight cells for each box; fewer, if the lists could have more than 64 entries for each box.
class FastGrid {
 public:
  /// Boxes around tetrahedra, and their corners, rounded to nearest. REQUIRES finite boxes.
  FastGrid(const std::vector<Box3d>& boxes, const std::vector<std::array<Point3d, 4>>& corners);

  /// All tetrahedra that contain the point, or one that rounds to it, are listed, ascending; others may be.
  std::span<const std::uint32_t> near(const Vec3d& p) const;

 private:
  bool fill(const std::vector<Box3d>& boxes, const std::vector<std::array<Point3d, 4>>& corners,
            std::size_t limit);
  Box3d cell_box(const std::array<std::size_t, 3>& at) const;
  std::size_t cell(double x, std::size_t axis) const;

  Box3d all_;
  double per_cell_[3] = {0, 0, 0};
  std::size_t size_[3] = {1, 1, 1};
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace veritope::internal
