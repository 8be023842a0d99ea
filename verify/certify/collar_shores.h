// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/collar_shores.h: winding numbers on the boundary of a collar, each with a path that does not meet the
// surface. Theory: docs/THEORY.md §5.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/collar/octree_root.h"
#include "topology/complex_boundary.h"
#include "verify/certify/star_walks.h"

namespace veritope {

/// A polyline from the least vertex of a component of the boundary through other vertices of that component, to
/// infinity or to a centre of a star box.
struct Shore {
  std::vector<std::uint32_t> vertices;  ///< the complex's vertices on the path, after the least one
  std::uint8_t direction = 0;           ///< 0..5: +x -x +y -y +z -z; 6: ends at end_box
  std::uint32_t end_box = 0;
  bool ends_outside = false;
  int winding = 0;  ///< 0 at infinity and at c+, 1 at c-
};

/// A shore for each component of the boundary, in order; nothing where no free path was found. REQUIRES a complete
/// cover, winding numbers 1 inside and 0 outside of every shell, and the surface in the interior of
/// |K|.
std::vector<std::optional<Shore>> find_shores(PieceForest& forest, const StarCover& cover,
                                              const OctreeRoot& root,
                                              const CommonSubdivision& complex,
                                              const ComplexBoundary& boundary);

}  // namespace veritope
