// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/bridge_proof.h: proves that the bridges of a microstructure are solids that meet the rest in
// their caps alone. The conditions R1 to R4 of docs/certificates/microstructure.md. Theory: docs/THEORY.md, MICRO-1.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "solids/micro/bridge/bridge_matrix.h"
#include "solids/micro/microstructure.h"
#include "solids/micro/tile_analysis.h"

namespace veritope {

/// What shows R1, R3 and R4 of one bridge.
struct BridgeWitness {
  BridgeMatrix matrix;
  std::vector<Rational> cuts;  ///< strictly increasing, between 0 and 1, at most 127
};

/// Why a bridge is not proved.
struct BridgeDefect {
  const char* condition = "";  ///< "B2" or "R1" to "R4"; of a sweep "Q1" to "Q4"
  std::size_t bridge = 0;      ///< or the number of the sweep
  std::string message;
};

/// What a bridge costs a checker: (p + 1)(q + 1)(1 + h)^2 / 64, h the bits of its longest number. The sum over all
/// bridges may be at most kMaxBridgeCost.
std::uint64_t bridge_cost(const MicroBridge& bridge);
inline constexpr std::uint64_t kMaxBridgeCost = std::uint64_t{1} << 36;

/// One for each bridge, in their order.
/// REQUIRES validate(micro); that the cage is that of micro and the tiles are its analysed tiles; that topology_of
/// finds no defect.
/// @cost near-linear in the bridges, if few of them are near each other: approximately 50 microseconds for each
std::variant<std::vector<BridgeWitness>, BridgeDefect> prove_bridges(
    const Microstructure& micro, const VModel& cage, const std::vector<AnalysedTile>& tiles);

/// For each cell of each grid the walls, a bit for each, that meet a wall of another cell with a tile.
/// @error kOverLimit: more than kMaxWallMeetings pairs of walls between grids
Result<std::vector<std::vector<std::uint8_t>>> walls_with_neighbours(const Microstructure& micro,
                                                                     const VModel& cage);

}  // namespace veritope
