// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/synthesis/wall_thickness.h: numbers of walls from a formula, so that neighbours have equal caps.
// Source: figure 8 of [HPE22].
#pragma once
#include <array>

#include "interval/formula/real_formula.h"
#include "robust/base/result.h"
#include "solids/micro/fill_cage.h"

namespace veritope {

/// The names of the variables of such formulas, in this order: where the middle of the wall is in space, and its
/// parameters, from 0 to 1 over the domain of its volume.
inline constexpr std::array<const char*, 6> kWallVariables = {"x", "y", "z", "u", "v", "w"};

/// Each wall between tiles gets the value of the formula at its middle, rounded to a multiple of 2^-20, once for both
/// neighbours (number_walls). Then the range of each tile that has one becomes that of all these numbers.
/// @error kBadArgument: no value, a value that is not decided, or one outside of the limits; the wall and the value
/// are named
/// REQUIRES a formula of kWallVariables, and what number_walls requires.
Status number_walls_by(const RealFormula& formula, const VModel& model,
                       const std::array<std::int32_t, 2>& limits, Microstructure& micro);

}  // namespace veritope
