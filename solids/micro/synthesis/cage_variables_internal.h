// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/synthesis/cage_variables_internal.h: what x, y, z, u, v, w mean in formulas about a cage. Internal to
// solids/micro/synthesis.
#pragma once
#include <array>
#include <vector>

#include "interval/formula/real_formula.h"
#include "solids/vmodel/v_model.h"

namespace veritope::internal {

/// The values of kWallVariables (wall_thickness.h) at a point of the parameters of a volume; x, y and z are 0 if the formula does not
/// depend on them, since they cost the most.
std::vector<Rational> cage_values(const RealFormula& formula, const VVolume& volume,
                                  const std::array<Rational, 3>& at);

}  // namespace veritope::internal
