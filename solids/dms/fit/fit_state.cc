// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_state.h"

#include <algorithm>
#include <cmath>

#include "solids/dms/dms_make.h"
#include "solids/dms/fit/fit_solver.h"

namespace veritope {

std::vector<double> FitState::mean_squares() const {
  std::vector<double> out(num_attributes());
  for (std::size_t i = 0; i < residuals.size(); ++i)
    out[i % out.size()] += residuals[i] * residuals[i];
  for (double& sum : out) sum /= static_cast<double>(points.size());
  return out;
}

std::vector<double> FitState::largest() const {
  std::vector<double> out(num_attributes());
  for (std::size_t i = 0; i < residuals.size(); ++i)
    out[i % out.size()] = std::max(out[i % out.size()], std::abs(residuals[i]));
  return out;
}

std::vector<double> FitState::by_tetrahedron() const {
  std::vector<double> out(model.tetrahedra.size());
  for (std::size_t i = 0; i < residuals.size(); ++i)
    out[points.tetrahedron[i / num_attributes()]] += residuals[i] * residuals[i];
  return out;
}

void refit(FitState& state) {
  DmsModel& model = state.model;
  const std::size_t attributes = state.num_attributes();
  set_control_by_rule(model, DmsControlRule::kGreville,
                      std::vector<Rational>(model.clouds.size() * attributes));
  state.control = fit_control(model);
  const SparseRows rows = FitBasis(model, state.control, state.points, false).rows();
  state.values = solve_least_squares(rows, smoothness_rows(model, state.control),
                                     state.control.count, state.points.values, attributes);
  const std::size_t components = model.num_components();
  for (std::size_t c = 0; c < state.control.count; ++c)
    for (std::size_t a = 0; a < attributes; ++a)
      model.control.values[c * components + 3 + a] =
          Rational::from_double(state.values[c * attributes + a]);
  state.residuals = state.points.values;
  state.square_sum = 0;
  for (std::size_t i = 0; i < state.points.size(); ++i)
    for (int k = rows.first[i]; k < rows.first[i + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      for (std::size_t a = 0; a < attributes; ++a)
        state.residuals[i * attributes + a] -=
            rows.value[at] *
            state.values[static_cast<std::size_t>(rows.column[at]) * attributes + a];
    }
  for (const double r : state.residuals) state.square_sum += r * r;
}

std::vector<std::uint32_t> undetermined_control(const FitState& state) {
  return find_undetermined(FitBasis(state.model, state.control, state.points, false).rows(),
                           state.control.count);
}

}  // namespace veritope
