// SPDX-License-Identifier: LGPL-3.0-or-later
// io/open_tile_file.h: tiles of curves and sheets from files of models.
#pragma once
#include <string>

#include "io/model_file.h"
#include "robust/base/result.h"
#include "solids/micro/micro_tile.h"

namespace veritope {

/// The curves of the file, cut at their knots, and its other shapes as tile_of has them, which need not be closed. An
/// open tile.
/// @error kBadArgument, with the entity: a curve that is rational or has not three coordinates; a control point out of
///        the unit cube. kOverLimit: a degree over kMaxTileDegree, more than kMaxTilePatches pieces. What tile_of
///        refuses but for curves, and what check_open_tile refuses.
Result<MicroTile> open_tile_of(const ModelFile& file, const std::string& name,
                               const MeshFile* polygons = nullptr);

}  // namespace veritope
