// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_shape.h"

#include <algorithm>
#include <cmath>

namespace veritope {
namespace {

using Triple = std::array<double, 3>;

double determinant(const std::array<Triple, 4>& p) {
  std::array<Triple, 3> e;
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t c = 0; c < 3; ++c) e[m][c] = p[m + 1][c] - p[0][c];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
         e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

}  // namespace

RoundedKnots::RoundedKnots(const DmsModel& model) : model_(model) {
  for (const DmsCloud& cloud : model.clouds) {
    clouds_.emplace_back();
    for (const DmsPoint& p : cloud)
      clouds_.back().push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
  }
}

double RoundedKnots::shape(const TetrahedronCorners& t) const {
  const std::array<Triple, 4> p = knots(t, {});
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      longest =
          std::max(longest, std::hypot(p[i][0] - p[j][0], p[i][1] - p[j][1], p[i][2] - p[j][2]));
  return std::max(0.0, determinant(p) / (longest * longest * longest));
}

bool RoundedKnots::has_core(const TetrahedronCorners& t) const {
  Triple core{};
  for (const Triple& p : knots(t, {}))
    for (std::size_t c = 0; c < 3; ++c) core[c] += p[c] / 4;
  bool is_inside = true;
  for (int sum = 0; sum < model_.degree; ++sum)
    for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& gamma) {
      if (!is_inside) return;
      const std::array<Triple, 4> w = knots(t, gamma);
      for (std::size_t m = 0; m < 4; ++m) {
        std::array<Triple, 4> moved = w;
        moved[m] = core;
        is_inside = is_inside && determinant(moved) > 0;
      }
    });
  return is_inside;
}

std::array<Triple, 4> RoundedKnots::knots(const TetrahedronCorners& t,
                                          const TetrahedralIndex& index) const {
  std::array<Triple, 4> out;
  for (std::size_t m = 0; m < 4; ++m) {
    const auto& cloud = clouds_[t[m]];
    const auto i = static_cast<std::size_t>(index[m]);
    out[m] = i < cloud.size() ? cloud[i] : cloud[0];
  }
  return out;
}

}  // namespace veritope
