// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/collar/octree_root.h: where an octree lies in space: its root cube, in doubles that are exact.
#pragma once
#include <cstdint>

#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "topology/octree_key.h"

namespace veritope {

/// A cube whose edge is OctreeKey::kGrid units. `unit` is a power of two, the corner a multiple of it of less than 2^52
/// units, so that every corner of a cell is a double.
struct OctreeRoot {
  Point3d corner{};
  double unit = 1;

  double edge() const { return unit * OctreeKey::kGrid; }
  /// The plane `grid` units above the corner, exactly. REQUIRES grid <= OctreeKey::kGrid.
  double plane(std::size_t axis, std::uint32_t grid) const { return corner[axis] + grid * unit; }
  Box3d box() const {
    return {corner,
            {plane(0, OctreeKey::kGrid), plane(1, OctreeKey::kGrid), plane(2, OctreeKey::kGrid)}};
  }
  Box3d box(OctreeKey key) const {
    const std::array<std::uint32_t, 3> low = key.corner();
    const std::uint32_t size = key.size();
    Box3d out;
    for (std::size_t k = 0; k < 3; ++k)
      out.lo[k] = plane(k, low[k]), out.hi[k] = plane(k, low[k] + size);
    return out;
  }
};

/// A root with `inner` in its interior, its edge at most 2.3 times the longest side. On each axis the planes between
/// cells of a level from 3 to 12 stay more than 0.09 of such a cell away from all multiples of half a cell's edge, and
/// 0.06 from these planes on another axis, mirrored at the diagonal: flat faces, which like few bits and diagonals, do
/// not lie on the walls of cells.
/// @error kOverLimit if `inner` is so small, or so far from the origin, that doubles cannot hold the grid.
Result<OctreeRoot> root_around(const Box3d& inner);

}  // namespace veritope
