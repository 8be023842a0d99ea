// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/facet_signs.h: the signs of the components of every facet's normal, and which facets are
// degenerate.
#pragma once
#include <cstdint>
#include <vector>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// Bit 2k: component k of the normal (v1 - v0) x (v2 - v0) is positive; bit 2k + 1: it is negative. If neither is set,
/// it is zero or was not decided.
using NormalSigns = std::uint8_t;

struct FacetSigns {
  std::vector<NormalSigns> signs;  ///< one for each facet; 0 iff it is degenerate
  /// Facets with a repeated id or exactly collinear corners, ascending.
  std::vector<std::uint32_t> degenerate;
};

/// Every facet that is not degenerate gets at least one certain bit. @cost O(F); exact arithmetic only where no
/// component is certain in floating point.
FacetSigns facet_signs(const TriangleMesh& mesh, unsigned jobs);

}  // namespace veritope
