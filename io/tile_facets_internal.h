// SPDX-License-Identifier: LGPL-3.0-or-later
// io/tile_facets_internal.h: flat triangles as patches of a tile. Internal to io.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/tile_file.h"

namespace veritope::internal {

struct TileFacet {
  std::array<TilePoint, 3> corners;      ///< counterclockwise, seen from outside
  std::optional<std::uint32_t> polygon;  ///< of which it is a part
};

/// Quadrilaterals of two triangles first, then the other triangles, in the order of their first triangles. A
/// triangle without area becomes a patch with a collapsed side, as any other one; analyse_tile refuses it.
std::vector<TilePatch> patches_of_facets(const std::vector<TileFacet>& facets, TileFacets how);

}  // namespace veritope::internal
