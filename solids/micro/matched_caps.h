// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/matched_caps.h: which walls have caps that are equal to caps of other cells. The conditions R2 and Q1
// of docs/certificates/microstructure.md.
#pragma once
#include <set>
#include <vector>

#include "solids/micro/tile_analysis.h"
#include "solids/micro/wall_pairs.h"

namespace veritope {

/// Those of the places whose wall has a cap that is equal to one in a wall that meets it.
/// REQUIRES ascending places, walls of cells with tiles; that the cage is that of micro and the tiles are its analysed
/// tiles; that topology_of finds no defect.
std::set<CapPlace> matched_caps(const Microstructure& micro, const VModel& cage,
                                const std::vector<AnalysedTile>& tiles,
                                const std::vector<CapPlace>& places);

}  // namespace veritope
