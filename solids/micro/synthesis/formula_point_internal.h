// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/synthesis/formula_point_internal.h: the variables of formulas about points of a cage. Internal to
// solids/micro/synthesis.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "interval/formula/real_formula.h"
#include "interval/ring_numbers.h"
#include "solids/vmodel/v_model.h"

namespace veritope::internal {

/// The values of kWallVariables at a point of the volume's parameters; x, y and z are 0 if the formula depends on none.
std::vector<Rational> formula_values(const RealFormula& formula, const VVolume& volume,
                                     const std::array<Rational, 3>& at);

/// Bounds of these values in binary64, for many points: a fraction of their cost.
class FormulaBoundsOfCage {
 public:
  explicit FormulaBoundsOfCage(const std::vector<VVolume>& cage);
  /// Nothing if they are not finite.
  std::optional<std::vector<Interval>> operator()(const RealFormula& formula, std::size_t volume,
                                                  const std::array<Rational, 3>& at) const;

 private:
  const std::vector<VVolume>& cage_;
  std::vector<BSpline<Interval, 3>> maps_;
};

}  // namespace veritope::internal
