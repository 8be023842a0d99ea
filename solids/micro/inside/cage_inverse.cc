// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "solids/micro/inside/cage_inverse_internal.h"
#include "splines/bezier_calculus.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {

namespace {

constexpr int kSteps = 30;
constexpr double kNear = 0x1p-30;  // of a step that ends the iteration

double determinant_of(const Point3d& a, const Point3d& b, const Point3d& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}
Point3d image_at(const BezierVolume<double>& map, const Point3d& u) {
  const auto v = evaluate<double, 3>(map, u);
  const double w = map.is_rational() ? v[3] : 1;
  return {v[0] / w, v[1] / w, v[2] / w};
}

// Newton's iteration, with differences in the place of derivatives, in the unit cube.
std::optional<Point3d> solve_from(const BezierVolume<double>& map, Point3d u, const Point3d& goal) {
  for (int step = 0; step < kSteps; ++step) {
    const Point3d image = image_at(map, u);
    Point3d off{};
    for (std::size_t c = 0; c < 3; ++c) off[c] = goal[c] - image[c];
    std::array<Point3d, 3> columns{};
    for (std::size_t a = 0; a < 3; ++a) {
      Point3d to = u;
      const double h = u[a] < 0.5 ? 0x1p-20 : -0x1p-20;
      to[a] += h;
      const Point3d moved = image_at(map, to);
      for (std::size_t c = 0; c < 3; ++c) columns[a][c] = (moved[c] - image[c]) / h;
    }
    const double det = determinant_of(columns[0], columns[1], columns[2]);
    double longest = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      std::array<Point3d, 3> with = columns;
      with[a] = off;
      const double move = determinant_of(with[0], with[1], with[2]) / det;
      if (!std::isfinite(move)) return std::nullopt;
      const double to = std::clamp(u[a] + std::clamp(move, -0.5, 0.5), 0.0, 1.0);
      longest = std::max(longest, std::abs(move));
      u[a] = to;
    }
    if (longest < kNear) return u;
  }
  return std::nullopt;
}

}  // namespace

CageInverse::CageInverse(const InsideParts& parts) : parts_(parts) {
  for (std::uint32_t v = 0; v < parts.volumes.size(); ++v) {
    Grid<3> grid;
    for (std::size_t a = 0; a < 3; ++a) grid.size[a] = parts.volumes[v].knots(a).size() - 1;
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const auto at = grid.index_of(i);
      const BezierVolume<Rational>& exact = parts.volumes[v].exact(at);
      std::vector<double> c;
      for (const Rational& x : exact.coefficients()) c.push_back(nearest_double(x));
      Span span{v,
                at,
                {exact.degrees(), exact.num_components(), exact.is_rational(), std::move(c)},
                empty_box()};
      const ScopedUpward upward;
      std::vector<Box3> points;
      if (!parts.volumes[v].net(at).points(&points)) continue;
      for (const Box3& p : points) {
        add({p[0].lo(), p[1].lo(), p[2].lo()}, &span.box);
        add({p[0].hi(), p[1].hi(), p[2].hi()}, &span.box);
      }
      spans_.push_back(std::move(span));
    }
  }
}

std::vector<CageParameters> CageInverse::all(const Point3d& point) const {
  std::vector<CageParameters> out;
  for (const Span& span : spans_) {
    if (!meets({point, point}, span.box)) continue;
    for (int start = 0; start < 9; ++start) {  // the middle, then the middles of the eight parts
      Point3d u{0.5, 0.5, 0.5};
      if (start > 0)
        for (std::size_t a = 0; a < 3; ++a) u[a] = ((start - 1) >> a & 1) != 0 ? 0.75 : 0.25;
      const auto found = solve_from(span.map, u, point);
      if (!found) continue;
      CageParameters at{span.volume, {}, {}};
      for (std::size_t a = 0; a < 3; ++a) {
        const auto& knots = parts_.volumes[span.volume].knots(a);
        const double begin = nearest_double(knots[span.at[a]]),
                     end = nearest_double(knots[span.at[a] + 1]);
        at.x[a] = begin + (end - begin) * (*found)[a];
        at.scale[a] = std::exp2(std::ceil(std::log2(nearest_double(knots.back() - knots.front()))));
      }
      out.push_back(at);
      break;
    }
  }
  return out;
}

}  // namespace veritope::internal
