// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/tile_caps_internal.h: the caps of a tile, and the conditions T2 and T3 of
// docs/certificates/microstructure.md. Internal to solids/micro.
#pragma once
#include <optional>
#include <vector>

#include "solids/micro/tile_analysis.h"

namespace veritope::internal {

/// Fills in the caps. REQUIRES tile.surface. `families` are the patches as family_of gives them.
void find_caps(const std::vector<BezierVolume<Rational>>& families, AnalysedTile& tile);

/// What is against T2 or T3, if anything. REQUIRES the caps.
std::optional<TileDefect> wall_defect(const std::vector<BezierVolume<Rational>>& families,
                                      const AnalysedTile& tile);

}  // namespace veritope::internal
