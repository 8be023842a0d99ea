// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_frame.h"

#include "solids/dms/dms_program.h"

namespace veritope {
namespace {

constexpr std::array<KnotNumber, 4> kNumbers = {0, 1, 2, 3};

std::array<std::array<double, 3>, 4> rounded(const std::array<DmsPoint, 4>& points) {
  std::array<std::array<double, 3>, 4> out;
  for (std::size_t m = 0; m < 4; ++m)
    for (std::size_t c = 0; c < 3; ++c) out[m][c] = nearest_double(points[m][c]);
  return out;
}

}  // namespace

FitFrame fit_frame(const std::array<DmsPoint, 4>& points) {
  const auto at = rounded(points);
  const auto frame = simplex_frame<double>(kNumbers, at, Sign::kPositive);
  if (!is_nearly_flat(frame, at)) return {frame.lambda};
  FitFrame out;
  const auto exact = simplex_frame<Rational>(kNumbers, points, Sign::kPositive);
  for (std::size_t m = 0; m < 4; ++m)
    for (std::size_t k = 0; k < 4; ++k) out.lambda[m][k] = nearest_double(exact.lambda[m][k]);
  return out;
}

std::array<DmsPoint, 4> last_knots(const DmsModel& model, std::uint32_t tetrahedron,
                                   const TetrahedralIndex& gamma) {
  std::array<DmsPoint, 4> out;
  for (std::size_t m = 0; m < 4; ++m)
    out[m] = model.knot(model.tetrahedra[tetrahedron][m], gamma[m]);
  return out;
}

bool has_flat_knots(const DmsModel& model, std::uint32_t tetrahedron) {
  const TetrahedronCorners& corners = model.tetrahedra[tetrahedron];
  bool is_collapsed = true, is_flat = false;
  for (const std::uint32_t v : corners) is_collapsed = is_collapsed && model.clouds[v].size() == 1;
  for_each_tetrahedral_index(
      is_collapsed ? 0 : model.degree - 1, [&](const TetrahedralIndex& gamma) {
        if (is_flat) return;
        const auto at = rounded(last_knots(model, tetrahedron, gamma));
        is_flat = is_nearly_flat(simplex_frame<double>(kNumbers, at, Sign::kPositive), at);
      });
  return is_flat;
}

}  // namespace veritope
