// SPDX-License-Identifier: LGPL-3.0-or-later
// io/tile_file.h: tiles of microstructures from files of models: meshes, surfaces, triangles and volumes in the unit
// cube. Design: docs/design/0081-tiles.md.
#pragma once
#include <string>

#include "io/model_file.h"
#include "robust/base/result.h"
#include "solids/micro/micro_tile.h"

namespace veritope {

/// How the triangles of a mesh become patches.
enum class TileFacets {
  /// Two triangles with one plane and a common edge, or of one polygon, that make a strictly convex quadrilateral
  /// are one patch; every other triangle is a patch with a collapsed side.
  kFewest,
  /// Each of these patches is cut at the middles of its sides, so that all are flat quadrilaterals, which mesh boxes
  /// (docs/certificates/star-box-2.md) can hold.
  kQuadrilaterals,
};

/// The patches of the file, as a closed surface should have them. Surfaces are cut at their knots; volumes are their
/// boundary faces; two patches that are equal and opposite, as where solids of two kinds are joined, are left out.
/// Nothing is decided: see analyse_tile. `name` becomes that of the tile.
/// @error kBadArgument, with the entity: curves, trimmed surfaces, rational patches, shapes that were left out when the
///        file was read, a microstructure; what check_tile refuses. kOverLimit: more than kMaxTilePatches patches
/// @param polygons  those of an .itd file that has splines, too (has_polygons_and_splines); else null
Result<MicroTile> tile_of(const ModelFile& file, const std::string& name, TileFacets facets,
                          const MeshFile* polygons = nullptr);

/// Whether read_itd_polygons reads something of the file that the model does not hold.
bool has_polygons_and_splines(const ModelFile& file);

}  // namespace veritope
