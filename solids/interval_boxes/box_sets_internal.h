// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/box_sets_internal.h: exact set operations on closed boxes.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "robust/base/box3d.h"

namespace veritope {

/// REQUIRES meets(a, b).
inline Box3d common_part(const Box3d& a, const Box3d& b) {
  Box3d out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.lo[k] = std::max(a.lo[k], b.lo[k]);
    out.hi[k] = std::min(a.hi[k], b.hi[k]);
  }
  return out;
}
/// [SSP01] 2: the longest edge, here of the first `dimension` ones.
inline double size_of(const Box3d& b, int dimension) {
  double e = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    e = std::max(e, b.hi[k] - b.lo[k]);
  return e;
}
/// Whether the box has positive length along the first `dimension` axes.
inline bool is_solid(const Box3d& b, int dimension) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    if (!(b.lo[k] < b.hi[k])) return false;
  return true;
}
/// Whether a lies in the interior of b, along the first `dimension` axes.
inline bool is_in_interior(const Box3d& a, const Box3d& b, int dimension) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    if (!(b.lo[k] < a.lo[k] && a.hi[k] < b.hi[k])) return false;
  return true;
}

/// Whether a box lies in the union of closed boxes. REQUIRES lo < hi on the first `dimension` axes of `box`; the other
/// axes are not examined. Parts of lower dimension need not be followed: the rest is open in the box. @cost
/// exponential in the worst case; few boxes meet a small one
bool is_in_union(const Box3d& box, const std::vector<Box3d>& boxes, int dimension);

}  // namespace veritope
