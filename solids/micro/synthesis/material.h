// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/synthesis/material.h: properties of a microstructure's points from formulas, such as the share of a
// second substance. Source: section 5 of [HPE22].
#pragma once
#include <string>

#include "interval/formula/real_formula.h"
#include "robust/base/result.h"
#include "solids/micro/microstructure.h"

namespace veritope {

/// Gives each corner of a cell the value of the formula there, rounded to a multiple of 2^-20. Corners with one place
/// in space have one value, that of the first of them, so that the property is continuous across glued faces, too.
/// @error kBadArgument: no value, a value that is not decided, or one of 2^32 or more; the corner is named
/// REQUIRES a formula of kWallVariables (wall_thickness.h), and a certified cage.
/// @cost one evaluation for each corner
Result<MicroMaterial> material_by(const RealFormula& formula, std::string name,
                                  const Microstructure& micro);

}  // namespace veritope
