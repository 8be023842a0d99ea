// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/micro_topology.h: how the tiles of a microstructure hang together. The conditions G1, G2 and T4, and
// the numbers of docs/certificates/microstructure.md, section 8.
#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "solids/micro/cap_matching.h"

namespace veritope {

struct MicroCounts {
  std::uint64_t cells = 0, tiles = 0, bridges = 0, glued_caps = 0, components = 0, shells = 0;
  std::int64_t genus = 0;  ///< the sum over the shells
  friend bool operator==(const MicroCounts&, const MicroCounts&) = default;
};

/// Why no certificate can speak of the microstructure.
struct MicroDefect {
  const char* condition = "";  ///< "G1", "G2", "T4"
  std::vector<CellWall> walls;
  std::string message;
};

/// A patch of the tile of a cell.
struct CellPatch {
  std::uint32_t grid = 0;
  std::uint64_t cell = 0;
  std::uint32_t patch = 0;
  friend bool operator==(const CellPatch&, const CellPatch&) = default;
};

/// @param first_patches  if not null, takes the first patch of each shell, in the order of grids, cells and patches
/// REQUIRES that the cage is that of micro, and the analysed tiles are its tiles, each with at most 64 caps.
/// @cost  near-linear in the cells; 20 bytes for each
std::variant<MicroCounts, MicroDefect> topology_of(const Microstructure& micro, const VModel& cage,
                                                   const std::vector<AnalysedTile>& tiles,
                                                   std::vector<CellPatch>* first_patches = nullptr);

/// Empties the cells whose tiles are not joined to those of the largest component by equal caps: the component with the
/// most tiles, of several that with the first cell.
/// @return those cells, by grids; or why they are not known: a cap that is neither equal to another nor apart from it
/// REQUIRES as topology_of
std::variant<std::vector<std::vector<std::uint64_t>>, MicroDefect> keep_largest_component(
    const VModel& cage, const std::vector<AnalysedTile>& tiles, Microstructure& micro);

/// Empties the cells whose tiles are not joined by equal caps to a tile at which a bridge starts. The rest is as of
/// keep_largest_component.
std::variant<std::vector<std::vector<std::uint64_t>>, MicroDefect> keep_bridged_components(
    const VModel& cage, const std::vector<AnalysedTile>& tiles, Microstructure& micro);

}  // namespace veritope
