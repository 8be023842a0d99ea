// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/tile_winding_internal.h: is a point in a tile? Internal to solids/micro/filter.
#pragma once
#include <optional>

#include "interval/box.h"
#include "solids/micro/filter/tile_pieces_internal.h"

namespace veritope::internal {

/// Whether the points of the box lie in the interior of the tile in space, or off it; nothing if that was not decided,
/// as for a point of the tile's surface. By the crossings of a ray with the surface, each counted as the winding number
/// of the border of a piece, seen along the ray. REQUIRES bounded pieces and a live ScopedUpward.
/// @cost the pieces near the ray
std::optional<bool> is_in_tile(const TilePieces& pieces, const Box3& point);

}  // namespace veritope::internal
