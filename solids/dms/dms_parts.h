// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_parts.h: a tetrahedron of a domain, cut into parts on each of which the map is one polynomial.
// Design: docs/design/0105-bezier-cells-of-simplex-splines.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/dms/dms_region.h"

namespace veritope {

/// A convex cell.
struct DmsCell {
  std::vector<DmsPoint> corners;
  std::vector<DmsPlane> planes;  ///< of its facets; it is where they have greater values
  std::vector<std::array<DmsPoint, 4>>
      tetrahedra;  ///< positively oriented; all have the first corner
};

/// Cells that tile a tetrahedron of the domain. No cell is reached by a triangle of knots that could crease the
/// map there, so that the map is one polynomial on each and DmsPieces accepts it. Where clouds are collapsed nearby,
/// the tetrahedron itself is the only one. A plane of knots cuts only those cells that its triangle may reach, so faces
/// of neighbours may have only parts in common.
/// Nothing if there would be more than max_cells. REQUIRES a tetrahedron that is not flat, max_cells > 0.
/// @cost for each cut the sets of knots near the cell; corners are exact, those of three planes of knots
std::optional<std::vector<DmsCell>> polynomial_parts(const DmsKnotTable& knots,
                                                     std::uint32_t tetrahedron,
                                                     std::size_t max_cells);

}  // namespace veritope
