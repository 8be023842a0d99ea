// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/grid_filter.h: the tiles of all cells of a cage against a solid: blocks of cells first, then
// tiles near the surface.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "solids/micro/filter/tile_filter.h"
#include "splines/bspline.h"

namespace veritope {

/// The tile of the cell with these numbers along the axes. Called for cells near the surface only, perhaps by several
/// threads at once. REQUIRES that it returns a shape, and equal shapes for equal numbers.
using TileOfCell =
    std::function<std::shared_ptr<const TileShape>(const std::array<std::uint32_t, 3>& cell)>;

struct GridStatus {
  Grid<3> cells;
  std::vector<CellStatus> status;  ///< of each cell, the last axis fastest
  /// How many cells have each status, in the order of CellStatus.
  std::array<std::uint64_t, 5> counts{};

  CellStatus at(const std::array<std::size_t, 3>& cell) const { return status[cells.at(cell)]; }
};

/// The statuses of all cells between the lines. A block of cells whose hull no facet meets is kept or outside as a
/// whole; other blocks are halved. The result does not depend on `jobs`.
/// REQUIRES a cage that is one to one on every cell; see TileFilter::find.
/// @error kBadArgument unless the cage has three coordinates, and the lines of each axis increase in its domain
///        and contain every knot between the first and the last of them; kOverLimit for more than 2^31 cells
/// @cost  the cells near the surface
Result<GridStatus> filter_grid(const TileFilter& filter, const BSplineVolume<Rational>& cage,
                               const std::array<std::vector<Rational>, 3>& lines,
                               const TileOfCell& tile, unsigned jobs,
                               const TileFilterLimits& limits = {});

}  // namespace veritope
