// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_ray_grid.h: parallel rays through a domain, one for each pixel of a picture.
#pragma once
#include <cstddef>

#include "robust/base/box3d.h"
#include "solids/dms/dms_line.h"

namespace veritope {

/// Ray (i, j), 0 <= i < columns, 0 <= j < rows, is the segment origin + i right + j down + t along, 0 <= t <= 1. The
/// coordinates are taken exactly, so that a ray is a segment with rational ends.
struct DmsRayGrid {
  static constexpr std::size_t kMaxSide = std::size_t{1} << 14;

  std::size_t columns = 1, rows = 1;  ///< from 1 to kMaxSide
  Point3d origin{}, right{}, down{}, along{};

  DmsLine ray(std::size_t i, std::size_t j) const;
  /// Whether the sides are in their range, all numbers are finite, and right, down and along span space.
  bool is_sound() const;
};

}  // namespace veritope
