// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/ruled.h: volumes of extrusion and ruled volumes: the segments between two surfaces.
// Source: seed paper 000, section 3.2.2.
#pragma once
#include "solids/volumes/cell_maps.h"

namespace veritope {

/// (u, v, w) -> S(u, v) + w vector, 0 <= w <= 1. Coordinates beyond the third stay.
/// @error kBadArgument for a vector of length 0 and a surface that is not in space; kOverLimit
Result<CellVolume> extruded(const CellSurface& surface, const CellPoint& vector);

/// (u, v, w) -> (1 - w) a(u, v) + w b(u, v), 0 <= w <= 1, in homogeneous coordinates if one of the surfaces is
/// rational; b over the domain of a. With equal weights these are the segments with constant speed; otherwise w is
/// another parameter of the same segments.
/// @error kBadArgument, kOverLimit as in_one_space
Result<CellVolume> ruled(const CellSurface& a, const CellSurface& b);

}  // namespace veritope
