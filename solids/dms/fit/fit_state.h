// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_state.h: a model while it is fitted: its knots, the control points that fit best, and the errors.
#pragma once
#include <vector>

#include "solids/dms/fit/fit_points.h"
#include "solids/dms/fit/fit_rows.h"

namespace veritope {

struct FitState {
  DmsModel
      model;  ///< control points by the Greville rule, so that positions are those of the identity
  FitPoints points;
  FitControl control;
  std::vector<double> values;     ///< of the control points' attributes
  std::vector<double> residuals;  ///< data less value, for each point and attribute
  double square_sum = 0;          ///< of the residuals

  std::size_t num_attributes() const { return model.attributes.size(); }
  /// For each attribute.
  std::vector<double> mean_squares() const;
  std::vector<double> largest() const;
  /// The sum of the squared residuals in each tetrahedron.
  std::vector<double> by_tetrahedron() const;
};

/// The control points that minimise the squared residuals; the smoothest ones where the data do not determine them.
/// REQUIRES points placed in the model's tetrahedra, clouds without defects.
void refit(FitState& state);

/// The control points that the data do not determine, ascending.
std::vector<std::uint32_t> undetermined_control(const FitState& state);

}  // namespace veritope
