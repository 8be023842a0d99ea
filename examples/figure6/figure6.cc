// SPDX-License-Identifier: LGPL-3.0-or-later
// Figure 6 of [SSP01]: b_i and b_j overlap where V is not; the box b_k between them is the sub-collection of Remark
// 3.1. The program also evaluates eq. 4, which says how small boxes must be for such a b_k to exist.
#include <cstdio>
#include <vector>

#include "models/plane_shapes.h"
#include "solids/interval_boxes/c3_exceptions.h"
#include "solids/interval_boxes/chord_circle.h"
#include "splines/bspline_make.h"

using namespace veritope;

namespace {

Box3d rectangle(double x0, double x1, double y0, double y1) { return {{x0, y0, 0}, {x1, y1, 0}}; }

void remark() {
  BoundaryModel model = BoundaryModel::make_planar({plane_shapes::circle()}).value();
  const std::vector<Box3d> boxes{rectangle(-0.8, 0.02, 0.5, 0.97), rectangle(-0.02, 0.8, 0.5, 0.97),
                                 rectangle(-0.4, 0.4, 0.45, 1.2)};
  const ConditionResult c3 = decide_conditions(model, boxes).value()[PaperCondition::kC3];
  std::printf("C3 %s\n", to_string(c3.answer));
  for (const C3Failure& f : explain_c3(model, boxes, c3)) {
    std::printf("  boxes %u and %u: %s; sub-collection of Remark 3.1:", f.i, f.j,
                to_string(f.exception));
    for (const auto k : f.sub_collection) std::printf(" %u", k);
    std::printf("\n");
  }
}

void equation4() {
  // A quarter of the unit circle: R_kappa = 1.
  std::array<KnotAxis<Rational>, 1> axis;
  axis[0].degree = 2;
  axis[0].knots = {0, 0, 0, 1, 1, 1};
  const auto quarter = make_bspline<1>(axis, 3, true, {1, 1, 0, 0, 1, 2, 1, 1, 2}).value();
  const auto r_kappa = least_curvature_radius(quarter).value();
  for (const double half : {2.0, 1.0, 0.5, 0.25, 0.125}) {
    const Interval e(half);
    const auto r_max = greatest_chord_radius(HalfWidths{{e, e}}).value();
    const auto holds = satisfies_eq4(r_max, r_kappa);
    std::printf("half-width %-6g R_max %.3f to %.3f: R_max <= R_kappa %s\n", half,
                r_max.radius.lo(), r_max.radius.hi(),
                !holds   ? "undecided"
                : *holds ? "holds"
                         : "fails");
  }
}

}  // namespace

int main() {
  remark();
  equation4();
}
