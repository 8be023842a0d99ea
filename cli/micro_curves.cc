// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/micro_curves.h"

#include <algorithm>

namespace veritope::cli {

bool has_curves(const Microstructure& micro) {
  return std::any_of(micro.tiles.begin(), micro.tiles.end(), [](const MicroTile& tile) {
    return std::any_of(tile.patches.begin(), tile.patches.end(),
                       [](const TilePatch& p) { return p.is_curve(); });
  });
}

Result<CurveBridges> bridge_curves(const MicroSolid& solid, const TileFilter& filter,
                                   const Microstructure& micro, const BridgeOptions& options) {
  if (solid.mesh() != nullptr) {
    const MeshProjection projection(*solid.mesh());
    return build_curve_bridges(filter, feet_on(projection), micro, options);
  }
  const PatchProjection projection(*solid.complex());
  return build_curve_bridges(filter, feet_on(projection), micro, options);
}

}  // namespace veritope::cli
