// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_knot_slope.h"

#include "robust/base/check.h"
#include "solids/dms/dms_table.h"
#include "splines/dms_knot_slope.h"

namespace veritope {

DmsKnotSlopes::DmsKnotSlopes(const DmsModel& model) : model_(model), evaluator_(model) {
  VT_CHECK(!model.control.is_separate, "derivatives are those of shared control points");
  for (const DmsCloud& cloud : model.clouds) {
    first_knot_.push_back(knots_.size());
    for (const DmsPoint& knot : cloud) knots_.emplace_back(knot);
  }
}

std::vector<std::array<Rational, 3>> DmsKnotSlopes::slope(const DmsPlace& place,
                                                          std::uint32_t vertex, int index) {
  std::vector<std::array<Rational, 3>> sums(model_.num_components());
  const ExactPoint3& u = place.path.start();
  for (const std::uint32_t t : evaluator_.near(u))
    for (std::size_t m = 0; m < 4; ++m) {
      if (model_.tetrahedra[t][m] != vertex) continue;
      internal::DmsTable table = internal::make_dms_table(model_, t, knots_, first_knot_);
      internal::DmsAnswers answers(table, place.path);
      SimplexSplines<Rational, internal::DmsAnswers> splines(answers, u.at());
      const auto control = [&](const TetrahedralIndex& beta) {
        return model_.value(control_of(model_, t, beta));
      };
      add_dms_knot_slope(splines, table.knots(), model_.degree, m, index, control, sums);
    }
  return sums;
}

}  // namespace veritope
