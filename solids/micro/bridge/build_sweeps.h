// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/build_sweeps.h: BridgeTilesToM and BuildBridgeTile, algorithms 3 and 4 of [HPE22], in space: the
// image of a cap is moved along a quadratic curve to the skin of the solid. Design: docs/design/0088-sweeps.md.
#pragma once
#include "solids/micro/bridge/build_bridges.h"

namespace veritope {

/// Adds a sweep to each cap of a tile that meets no other cell with a tile, where it is proved that the sweep satisfies
/// Q1 to Q4 of docs/certificates/microstructure.md, lies in the interior of the solid, and ends within `skin` of its
/// surface. Up to 16 curves are tried for each cap. The kink of the report is the angle between the begin of the curve
/// and the image of the axis across the wall; a drop for kBox says that the wall holds more than a cap of one patch.
/// REQUIRES as build_bridges; no sweeps.
/// @error kOverLimit: too many pairs of walls between grids, too many sweeps; FastSpline::prepare
/// @cost  ten milliseconds for each cap
Result<BridgeReport> build_sweeps(const TriangleMesh& mesh, const VModel& cage,
                                  const std::vector<AnalysedTile>& tiles,
                                  const BridgeOptions& options, Microstructure& micro);
/// Leads sweeps to a complex of patches that bounds a solid (certified valid), in the same way.
Result<BridgeReport> build_sweeps(const PatchComplex& complex, const VModel& cage,
                                  const std::vector<AnalysedTile>& tiles,
                                  const BridgeOptions& options, Microstructure& micro);

}  // namespace veritope
