// SPDX-License-Identifier: LGPL-3.0-or-later
// Figure 5 of [SSP01]: exceptions to C3, at the top of the unit circle: (a) due to varying sizes of boxes, (b) due to
// small features; and a contact, which a dyadic step eliminates.
#include <cstdio>
#include <vector>

#include "models/plane_shapes.h"
#include "solids/interval_boxes/c3_exceptions.h"

using namespace veritope;

namespace {

Box3d rectangle(double x0, double x1, double y0, double y1) { return {{x0, y0, 0}, {x1, y1, 0}}; }

void report(const char* title, const std::vector<Box3d>& boxes) {
  BoundaryModel model = BoundaryModel::make_planar({plane_shapes::circle()}).value();
  const ConditionResult c3 = decide_conditions(model, boxes).value()[PaperCondition::kC3];
  std::printf("%s: C3 %s\n", title, to_string(c3.answer));
  for (const BoxOffence& o : c3.offences) std::printf("  %s\n", to_string(o).c_str());
  for (const C3Failure& f : explain_c3(model, boxes, c3)) {
    std::printf("  exception %d, %s", static_cast<int>(f.exception), to_string(f.exception));
    for (const auto k : f.sub_collection) std::printf("; mended by box %u", k);
    if (f.resized) std::printf("; box %u resized by %g", f.i, f.resized->step);
    std::printf("\n");
  }
}

}  // namespace

int main() {
  const Box3d large = rectangle(-0.9, 0.06, 0.3, 0.97), small = rectangle(0.04, 0.3, 0.9, 0.99);
  report("(a) a large box reaches over a small one",
         {large, rectangle(-0.3, 0.2, 0.93, 1.1), small});
  report("(b) the top is a small feature",
         {rectangle(-0.8, 0.02, 0.5, 0.97), rectangle(-0.02, 0.8, 0.5, 0.97)});
  report("contact", {rectangle(-0.5, 0.125, 0.75, 1.25), rectangle(0.125, 0.5, 0.75, 1.25)});
}
