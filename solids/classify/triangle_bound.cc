// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/triangle_bound.h"

#include <algorithm>
#include <cmath>

#include "interval/box_geometry.h"

namespace veritope {

std::array<double, 2> near_weights(const Point3d& q, const std::array<Vec3d, 3>& triangle) {
  std::array<Point3d, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = {triangle[i].x, triangle[i].y, triangle[i].z};
  const auto minus = [](const Point3d& a, const Point3d& b) {
    return Point3d{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const Point3d& a, const Point3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  // Weights of the corners 1 and 2 of a point near the nearest one: any are right, these are good.
  double best = HUGE_VAL;
  std::array<double, 2> weights{};
  const auto consider = [&](double v, double w) {
    if (!(v >= 0 && w >= 0 && v + w <= 1)) return;
    Point3d d = minus(q, p[0]);
    for (std::size_t c = 0; c < 3; ++c) d[c] -= v * (p[1][c] - p[0][c]) + w * (p[2][c] - p[0][c]);
    const double square = dot(d, d);
    if (square < best) best = square, weights = {v, w};
  };
  const Point3d e1 = minus(p[1], p[0]), e2 = minus(p[2], p[0]), e3 = minus(p[2], p[1]);
  const Point3d f = minus(q, p[0]), g = minus(q, p[1]);
  const double a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2), d = dot(e1, f), e = dot(e2, f);
  const double det = a * c - b * b;
  consider((c * d - b * e) / det, (a * e - b * d) / det);
  consider(std::clamp(d / a, 0.0, 1.0), 0);
  consider(0, std::clamp(e / c, 0.0, 1.0));
  const double s = std::clamp(dot(e3, g) / dot(e3, e3), 0.0, 1.0);
  consider(std::max(0.0, std::nextafter(1 - s, 0)), s);
  consider(0, 0);
  consider(1, 0);
  consider(0, 1);
  return weights;
}

double distance_bound(const Box3& point, const std::array<Vec3d, 3>& triangle) {
  const std::array<double, 2> weights = near_weights(internal::approx_middle(point), triangle);
  std::array<Point3d, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = {triangle[i].x, triangle[i].y, triangle[i].z};
  const Interval v(weights[0]), w(weights[1]);
  const Interval u = intersection(Interval(1.0) - v - w, Interval::from_bounds(0, 1));
  Box3 off;
  for (std::size_t k = 0; k < 3; ++k)
    off[k] = point[k] - (u * Interval(p[0][k]) + v * Interval(p[1][k]) + w * Interval(p[2][k]));
  return internal::norm(off).hi();
}

}  // namespace veritope
