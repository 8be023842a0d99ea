// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/matched_caps.h"

#include <algorithm>
#include <array>

#include "solids/micro/cap_matching.h"

namespace veritope {
namespace {

CapPlace place_of_wall(const CellWall& w) { return {w.grid, w.cell, w.wall}; }

}  // namespace

std::set<CapPlace> matched_caps(const Microstructure& micro, const VModel& cage,
                                const std::vector<AnalysedTile>& tiles,
                                const std::vector<CapPlace>& places) {
  std::set<CapPlace> out;
  CapMatcher matcher(tiles);
  const auto is_named = [&](const CellWall& w) {
    return std::binary_search(places.begin(), places.end(), place_of_wall(w));
  };
  for_each_wall_pair(micro, cage, [&](const WallPair& pair) {
    if (!is_named(pair.walls[0]) && !is_named(pair.walls[1])) return true;
    std::array<std::uint32_t, 2> kinds{};
    std::array<WallNumbers, 2> numbers{};
    for (std::size_t side = 0; side < 2; ++side) {
      const MicroGrid& grid = micro.grids[pair.walls[side].grid];
      kinds[side] = grid.tiles[pair.walls[side].cell] - 1u;
      numbers[side] = grid.numbers_of(grid.shape().index_of(pair.walls[side].cell));
    }
    if (!matcher.match(pair, kinds, numbers).equal.empty())
      for (const CellWall& w : pair.walls)
        if (is_named(w)) out.insert(place_of_wall(w));
    return true;
  });
  return out;
}

}  // namespace veritope
