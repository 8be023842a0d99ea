// SPDX-License-Identifier: LGPL-3.0-or-later
// Figure 3 of [SSP01]: the size of boxes has little influence on approximate equality. (a) A notch with the same
// pattern of boxes at every scale: two boxes bridge it and enclose a cavity that the solid does not have. (b) Boxes of
// a quarter of the model's size around a circle.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "models/plane_shapes.h"
#include "solids/interval_boxes/box_union.h"
#include "solids/interval_boxes/c3_exceptions.h"

using namespace veritope;

namespace {

Box3d rectangle(double x0, double x1, double y0, double y1) { return {{x0, y0, 0}, {x1, y1, 0}}; }

// Around the boundary of [-4,8] x [-6,6] without the notch |y| < x/4; the boxes at the notch's apex have the size s.
std::vector<Box3d> boxes_at_scale(double s) {
  std::vector<Box3d> out{rectangle(-4.5, -3.5, -6.5, 6.5), rectangle(-4.5, 8.5, -6.5, -5.5),
                         rectangle(-4.5, 8.5, 5.5, 6.5),   rectangle(7.5, 8.5, -6.5, -1.5),
                         rectangle(7.5, 8.5, 1.5, 6.5),    rectangle(-s, s, -s, s)};
  const auto mirrored = [&](double x0, double x1, double y0, double y1) {
    out.push_back(rectangle(x0, x1, y0, y1));
    out.push_back(rectangle(x0, x1, -y1, -y0));
  };
  mirrored(0.875 * s, 2.125 * s, 0.0625 * s, 0.75 * s);
  mirrored(2 * s, 3.25 * s, -0.03125 * s, s);  // across the middle of the notch
  for (double x = 3 * s; x < 7.625; x *= 1.5) mirrored(x, 1.625 * x, x / 8, x / 1.875);
  return out;
}

// The number of boundary curves of the interval solid M∪|B|.
std::size_t boundaries(BoundaryModel& model, std::vector<Box3d> boxes) {
  for (Box3d& b : boxes) b.lo[2] = 0, b.hi[2] = 1;
  const BoxGrid grid = BoxGrid::make(boxes).value();
  const auto inside = [&](const Point3d& p) -> std::optional<bool> {
    Point3d q{};
    for (std::size_t k = 0; k < 2; ++k) q[k] = std::ldexp(p[k], model.forest().scale());
    const auto w = winding_number(model.forest(), q);
    return w ? std::optional(*w == 1) : std::nullopt;
  };
  const auto topology = topology_of(grid.filled_where(inside, 2).value()).value();
  // A planar solid with n boundary curves, times an interval: a body of genus n - 1.
  return static_cast<std::size_t>(2 - topology.boundary_euler.at(0) / 2);
}

void line(const char* name, BoundaryModel& model, const std::vector<Box3d>& boxes) {
  const PaperConditions all = decide_conditions(model, boxes).value();
  std::printf("%-12s", name);
  for (const ConditionResult& r : all.results) std::printf(" %-9s", to_string(r.answer));
  std::printf(" %zu\n", boundaries(model, boxes));
}

}  // namespace

int main() {
  std::printf("%-12s", "boxes");
  for (std::size_t c = 0; c < kNumPaperConditions; ++c)
    std::printf(" %-9s", name_of(static_cast<PaperCondition>(c)));
  std::printf(" boundaries of M and boxes\n");
  BoundaryModel notch =
      BoundaryModel::make_planar(
          {plane_shapes::polygon({{-4, -6}, {8, -6}, {8, -2}, {0, 0}, {8, 2}, {8, 6}, {-4, 6}})})
          .value();
  for (int k = 1; k <= 8; ++k) {
    const std::string name = "(a) 2^-" + std::to_string(k);
    line(name.c_str(), notch, boxes_at_scale(std::ldexp(1, -k)));
  }
  BoundaryModel circle = BoundaryModel::make_planar({plane_shapes::circle()}).value();
  std::vector<Box3d> around;
  const std::array<std::array<double, 2>, 4> eighth{
      {{1, 0}, {0.921875, 0.3828125}, {0.703125, 0.703125}, {0.3828125, 0.921875}}};
  for (int quarter = 0; quarter < 4; ++quarter)
    for (auto p : eighth) {
      for (int q = 0; q < quarter; ++q) p = {-p[1], p[0]};
      around.push_back(rectangle(p[0] - 0.25, p[0] + 0.25, p[1] - 0.25, p[1] + 0.25));
    }
  line("(b) 1/4", circle, around);
}
