// SPDX-License-Identifier: LGPL-3.0-or-later
// Bezier triangles in pictures: rounded, and cut into flat triangles along a uniform grid of barycentric coordinates.
#include <algorithm>

#include "render/spline_view_internal.h"

namespace veritope::internal {
namespace {

double norm_of(const Point3d& a, const Point3d& b, const Point3d& c,
               const Point3d& d) {  // |a - b - c + d|
  double square = 0;
  for (std::size_t x = 0; x < 3; ++x) {
    const double difference = (a[x] - b[x]) - (c[x] - d[x]);
    square += difference * difference;
  }
  return std::sqrt(square);
}

// The largest second difference of control points along two edges that start in one corner, equal or not.
double second_difference(const BezierTriangle<double>& map) {
  std::vector<Point3d> points;
  for (std::size_t i = 0; i < map.count(); ++i) points.push_back(control_point(map, i));
  const auto at = [&](int j, int k) -> const Point3d& { return points[triangle_index(j, k)]; };
  double most = 0;
  for_each_triangle_index(map.degree() - 2, [&](int, int j, int k) {
    const Point3d &corner0 = at(j, k), &corner1 = at(j + 2, k), &corner2 = at(j, k + 2);
    const Point3d &middle0 = at(j + 1, k + 1), &middle1 = at(j, k + 1), &middle2 = at(j + 1, k);
    most = std::max(
        {most, norm_of(corner1, middle2, middle2, corner0),
         norm_of(corner2, middle1, middle1, corner0), norm_of(corner2, middle0, middle0, corner1),
         norm_of(middle0, middle1, middle2, corner0), norm_of(middle1, middle0, middle2, corner1),
         norm_of(middle2, middle0, middle1, corner2)});
  });
  return most;
}

}  // namespace

Result<BezierTriangle<double>> rounded_triangle(const ExactTriangle& triangle,
                                                std::uint64_t entity) {
  std::vector<double> coefficients;
  coefficients.reserve(triangle.coefficients().size());
  for (const Rational& x : triangle.coefficients()) {
    coefficients.push_back(nearest_double(x));
    if (!std::isfinite(coefficients.back()))
      return view_error(Code::kNotFinite, entity, "a coordinate is too large for binary64");
  }
  BezierTriangle<double> out(triangle.degree(), triangle.num_components(), triangle.is_rational(),
                             std::move(coefficients));
  if (out.is_rational())
    for (const double w : out.component(out.dimension()))
      if (w == 0) return view_error(Code::kNotFinite, entity, "a weight is too small for binary64");
  return out;
}

std::size_t triangle_divisions(const BezierTriangle<double>& triangle, double chord) {
  constexpr std::size_t kMost = 256;
  const int p = triangle.degree();
  if (p < 2) return 1;
  const double n =
      std::ceil(std::sqrt(2.0 / 9 * p * (p - 1) * second_difference(triangle) / chord));
  if (!(n >= 1)) return 1;
  return n > kMost ? kMost : static_cast<std::size_t>(n);
}

std::vector<Point3d> triangle_grid(const BezierTriangle<double>& triangle, std::size_t divisions) {
  const int n = static_cast<int>(divisions);
  std::vector<Point3d> points;
  points.reserve(num_triangle_coefficients(n));
  for_each_triangle_index(n, [&](int i, int j, int k) {
    const Barycentric<double> at{static_cast<double>(i) / n, static_cast<double>(j) / n,
                                 static_cast<double>(k) / n};
    points.push_back(to_point(evaluate(triangle, at), triangle.is_rational()));
  });
  return points;
}

void append_triangle_grid(std::size_t divisions, std::uint32_t first,
                          std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto id = [&](int j, int k) {
    return first + static_cast<std::uint32_t>(triangle_index(j, k));
  };
  const int n = static_cast<int>(divisions);
  for_each_triangle_index(n - 1, [&](int, int j, int k) {
    triangles.push_back({id(j, k), id(j + 1, k), id(j, k + 1)});
    if (j > 0) triangles.push_back({id(j, k), id(j, k + 1), id(j - 1, k + 1)});
  });
}

}  // namespace veritope::internal
