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

}  // namespace veritope
