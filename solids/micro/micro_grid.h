// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/micro_grid.h: a grid of cells over all of a volume's parameters.
#pragma once
#include <array>
#include <cstdint>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"

namespace veritope {

/// Cells without tiles and without numbers of walls. Along each axis there are counts[axis] intervals. Each span
/// between different knots is cut into equal ones: first it gets one, then the whole part of its share of the others,
/// by length; those that are left go to the spans with the largest remainders, of equal ones to the first.
/// @error kBadArgument: fewer intervals than spans along an axis; kOverLimit: more than kMaxMicroCells cells
Result<MicroGrid> make_micro_grid(const VVolume& volume, std::uint32_t number,
                                  const std::array<std::uint64_t, 3>& counts);

/// One grid for each volume, with the counts of that volume, or with the only ones for all.
/// @error as make_micro_grid; kOverLimit: more than max_cells cells in all
/// REQUIRES one element of counts, or one for each volume.
Result<std::vector<MicroGrid>> make_micro_grids(
    const std::vector<VVolume>& cage, const std::vector<std::array<std::uint64_t, 3>>& counts,
    std::uint64_t max_cells);

}  // namespace veritope
