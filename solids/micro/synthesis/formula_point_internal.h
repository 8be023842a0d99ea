// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/synthesis/formula_point_internal.h: the variables of formulas about points of a cage. Internal to
// solids/micro/synthesis.
#pragma once
#include <array>
#include <vector>

#include "interval/formula/real_formula.h"
#include "solids/vmodel/v_model.h"

namespace veritope::internal {

/// The values of kWallVariables at a point of the volume's parameters; x, y and z are 0 if the formula depends on none.
std::vector<Rational> formula_values(const RealFormula& formula, const VVolume& volume,
                                     const std::array<Rational, 3>& at);

}  // namespace veritope::internal
