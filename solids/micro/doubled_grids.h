// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/doubled_grids.h: cells that are half as wide along u and v from a layer of w on.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"

namespace veritope {

/// Two grids a volume: the layers of w before `layer` as make_micro_grid makes them, and the others, in which each cell
/// is cut in halves along u and v.
/// @error as make_micro_grid; kBadArgument unless 1 <= layer < counts[2]; kOverLimit: more than max_cells cells in
/// all, or more than kMaxMicroGrids grids
Result<std::vector<MicroGrid>> make_doubled_grids(const std::vector<VVolume>& cage,
                                                  const std::array<std::uint64_t, 3>& counts,
                                                  std::uint64_t layer, std::uint64_t max_cells);

/// Whether the cell lies in the last layer of w before cells of half the width. REQUIRES a grid of make_doubled_grids.
bool is_before_doubling(const VVolume& volume, const MicroGrid& grid, std::uint64_t cell);

}  // namespace veritope
