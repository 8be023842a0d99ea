// SPDX-License-Identifier: LGPL-3.0-or-later
// render/dms_cells.h: a simplex-spline solid for viewers: VTK's unstructured grids with Bezier tetrahedra, one for each
// part of the domain on which the map is one polynomial.
// Design: docs/design/0105-bezier-cells-of-simplex-splines.md.
#pragma once
#include <cstdint>
#include <string>

#include "robust/base/result.h"
#include "solids/dms/dms_polynomials.h"

namespace veritope {

struct DmsCells {
  std::string vtu;  ///< a .vtu file in ASCII
  std::uint64_t num_cells = 0;
};

/// The map of the model, whose control points on each part are exact and then rounded to the nearest binary64; its
/// attributes, but not those of an attribute domain, with their own coefficients on the control points; and the
/// tetrahedron of the domain that each cell is a part of. Control points that cells share are written once.
/// Bytes do not depend on `jobs`.
/// REQUIRES a model without defects (solids/dms/dms_defects.h) that has coordinates.
/// @error kOverLimit with the tetrahedron as the entity, or for more than 2^25 points; kNotFinite likewise for a number
/// beyond binary64
/// @cost the polynomial of each convex cell (solids/dms/dms_piece.h) and its restrictions; collapsed clouds leave one
/// cell a tetrahedron, inner ones of degree 2 some tens, outward ones of degree 3 hundreds or thousands
Result<DmsCells> dms_cells(const DmsModel& model, const DmsCellOptions& options);

}  // namespace veritope
