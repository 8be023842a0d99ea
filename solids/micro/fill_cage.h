// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/fill_cage.h: a tile in every cell of a cage: line 1 of Algorithm 1 of [HPE22].
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"

namespace veritope {

/// The tile with arms to these walls, a bit for each wall 2 axis + end.
using TileOfArms = std::function<Result<MicroTile>(unsigned arms)>;

/// Cells over all parameters of all volumes, counts along the axes of each volume (make_micro_grid), all with the
/// tile; without an arm to a wall that lies in a collapsed face of the cage. Numbers of walls are all 0 where the
/// tile needs them.
/// @error as make_micro_grid and the tile; kOverLimit: more than max_cells cells in all
/// REQUIRES that the model is that of the cage.
Result<Microstructure> fill_cage(std::vector<VVolume> cage, const VModel& model,
                                 const std::array<std::uint64_t, 3>& counts, const TileOfArms& tile,
                                 std::uint64_t max_cells);

/// Which of several tiles the cell of a grid holds.
using ChooseTile = std::function<Result<std::size_t>(const VVolume& volume, const MicroGrid& grid,
                                                     std::uint64_t cell)>;
/// Calls choose for each cell, in order. Equal tiles are one.
/// @error  that of choose, too
/// REQUIRES that choose returns numbers of tiles.
Result<Microstructure> fill_cage(std::vector<VVolume> cage, const VModel& model,
                                 const std::array<std::uint64_t, 3>& counts,
                                 const std::vector<TileOfArms>& tiles, const ChooseTile& choose,
                                 std::uint64_t max_cells);

/// The tiles of the cells of these grids, as fill_cage chooses them. REQUIRES grids without tiles, by volumes, whose
/// boxes have no inner point in common.
/// @error  as choose and the tiles
Result<Microstructure> fill_grids(std::vector<VVolume> cage, const VModel& model,
                                  std::vector<MicroGrid> grids,
                                  const std::vector<TileOfArms>& tiles, const ChooseTile& choose);

/// A wall of a grid: its grid, its axis, and its place among the walls across that axis.
struct GridWall {
  std::uint32_t grid = 0;
  std::size_t axis = 0;
  std::array<std::size_t, 3> at{};
};
/// Gives each wall of a cell with a tile its number, and the others 0. A wall that lies in two glued faces of the
/// cage has one number, that of the first of its grids: the function is called once for it. So have a wall of a grid
/// and the 2 x 2 walls of another grid of its volume that lie in it.
/// @error that of the function
/// REQUIRES micro.has_walls(), and that the model is that of the cage.
Status number_walls(const VModel& model,
                    const std::function<Result<std::int32_t>(const GridWall&)>& number,
                    Microstructure& micro);
/// Sets the numbers of walls without a tile beside them to 0.
void clear_unused_walls(Microstructure& micro);

/// The middle of the wall in the parameters of its volume.
std::array<Rational, 3> middle_of(const Microstructure& micro, const GridWall& wall);

}  // namespace veritope
