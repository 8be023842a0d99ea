// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/synthesis/filter_tiles.h: FilterTilesToM, Algorithm 2 of [HPE22]: the tiles of a microstructure that
// lie in the interior of a solid. Design: docs/design/0074-filtering-tiles.md.
#pragma once
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/filter/grid_filter.h"
#include "solids/micro/microstructure.h"

namespace veritope {

/// Takes away the tiles that are not proved to lie in the interior of the solid. The result does not depend on
/// `jobs`.
/// @return the status of each cell of each grid. Cells without a tile before are kOutside.
/// @error as filter_grid
/// REQUIRES micro as validate() accepts it, but for walls without neighbours; its volumes are one to one, its tiles
/// embedded.
Result<std::vector<GridStatus>> filter_tiles_to(const TileFilter& filter, unsigned jobs,
                                                Microstructure& micro);

}  // namespace veritope
