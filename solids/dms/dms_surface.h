// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_surface.h: the map on the boundary of its domain, as Bezier triangles.
#pragma once
#include <array>
#include <variant>
#include <vector>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_model.h"
#include "solids/dms/dms_tiles.h"
#include "splines/bezier_triangle.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

/// x, y, z of the map on each of some tiles of the boundary, exactly. REQUIRES an evaluator of the model.
/// @cost that of DmsPieces for each (solids/dms/dms_piece.h)
std::vector<BezierTriangle<Rational>> patches_on(const DmsModel& model,
                                                 const DmsEvaluator& evaluator,
                                                 const std::vector<DmsTile>& tiles,
                                                 const DmsTileOptions& options = {});

/// x, y, z of the map on the tiles of the boundary's faces (solids/dms/dms_tiles.h), face after face: exactly, with the
/// degree of the model. Each has its normal out of the solid, if the map is one to one and det Ds > 0.
/// REQUIRES the complex of the model, and a model without defects (solids/dms/dms_defects.h).
/// @cost the tiles, and patches_on them
std::variant<std::vector<BezierTriangle<Rational>>, DmsOpenFace> boundary_patches(
    const DmsModel& model, const TetrahedralComplex& complex, const DmsTileOptions& options = {});

/// The map with its attributes on a tile of the boundary, whose corners are those of its parameter triangle.
struct DmsBoundaryPiece {
  std::array<DmsPoint, 3> corners;
  BezierTriangle<Rational> map;
};

/// As boundary_patches, with all components of the model: x, y, z and the attributes.
std::variant<std::vector<DmsBoundaryPiece>, DmsOpenFace> boundary_pieces(
    const DmsModel& model, const TetrahedralComplex& complex, const DmsTileOptions& options = {});

}  // namespace veritope
