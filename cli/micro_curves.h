// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/micro_curves.h: the bridges of tiles of curves in veritope micro.
#pragma once
#include "cli/micro_solid.h"
#include "solids/micro/bridge/curve_bridges.h"

namespace veritope::cli {

/// Whether some tile has a curve.
bool has_curves(const Microstructure& micro);

/// @error as build_curve_bridges
/// REQUIRES as build_curve_bridges, with the solid's filter.
Result<CurveBridges> bridge_curves(const MicroSolid& solid, const TileFilter& filter,
                                   const Microstructure& micro, const BridgeOptions& options);

}  // namespace veritope::cli
