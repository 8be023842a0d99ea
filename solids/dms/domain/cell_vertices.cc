// SPDX-License-Identifier: LGPL-3.0-or-later
// The vertices of convex cells: their kinds, sides and places.
#include <algorithm>
#include <array>

#include "predicates/implicit_homogeneous.h"
#include "predicates/orient3d.h"
#include "robust/integer.h"
#include "robust/rational.h"
#include "solids/dms/domain/convex_cells.h"

namespace veritope {
namespace {

// The exact place of a point that N explicit ones define.
template <std::size_t N>
DmsPoint place_of(const std::array<Vec3d, N>& points) {
  std::array<Integer, 3 * N> v;
  const int exponent = internal::to_numbers(internal::coordinates(points), v);
  const auto t = internal::triples(v);
  const auto h = formulas::homogeneous(t);
  const Rational unit = Rational::power_of_two(exponent);
  const auto at = [&](const Integer& base, const Integer& numerator) {
    return Rational(base * h.denominator + numerator, h.denominator) * unit;
  };
  return {at(t[0].x, h.numerator.x), at(t[0].y, h.numerator.y), at(t[0].z, h.numerator.z)};
}

}  // namespace

std::array<Vec3d, 3> ConvexCells::points_of(std::uint32_t plane) const {
  const CellPlane& p = planes_[plane];
  return {points_[p[0]], points_[p[1]], points_[p[2]]};
}

LinePlanePoint ConvexCells::line_plane(const std::array<std::uint32_t, 2>& line,
                                       std::uint32_t plane) const {
  const auto p = points_of(plane);
  return LinePlanePoint(points_[line[0]], points_[line[1]], p[0], p[1], p[2]);
}

ThreePlanePoint ConvexCells::three_planes(const std::array<std::uint32_t, 2>& line,
                                          std::uint32_t plane) const {
  const auto a = points_of(line[0]), b = points_of(line[1]), c = points_of(plane);
  return ThreePlanePoint({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]});
}

AnyPoint3 ConvexCells::vertex(std::uint32_t v) const {
  const Vertex& x = vertices_[v];
  if (x.kind == Vertex::Kind::kInput) return points_[v];
  if (x.kind == Vertex::Kind::kLinePlane) return line_planes_[x.number];
  return three_planes_[x.number];
}

DmsPoint ConvexCells::place(std::uint32_t v) const {
  const Vertex& x = vertices_[v];
  if (x.kind == Vertex::Kind::kLinePlane) return place_of(line_planes_[x.number].point().points());
  if (x.kind == Vertex::Kind::kThreePlanes)
    return place_of(three_planes_[x.number].point().points());
  const Vec3d& p = points_[v];
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}

Sign ConvexCells::side(const std::array<Vec3d, 3>& p, std::uint32_t v) const {
  const Vertex& x = vertices_[v];
  if (x.kind == Vertex::Kind::kInput) return orient3d(p[0], p[1], p[2], points_[v]);
  if (x.kind == Vertex::Kind::kLinePlane) return orient3d(p[0], p[1], p[2], line_planes_[x.number]);
  return orient3d(p[0], p[1], p[2], three_planes_[x.number]);
}

Sign ConvexCells::side(std::uint32_t plane, std::uint32_t v) const {
  const Vertex& x = vertices_[v];
  const CellPlane& p = planes_[plane];
  const auto is_of_plane = [&](std::uint32_t id) {
    return std::find(p.begin(), p.end(), id) != p.end();
  };
  // Most zeros are known without arithmetic.
  if (x.kind == Vertex::Kind::kInput && is_of_plane(v)) return Sign::kZero;
  if (x.kind == Vertex::Kind::kLinePlane &&
      (x.of[2] == plane || (is_of_plane(x.of[0]) && is_of_plane(x.of[1]))))
    return Sign::kZero;
  if (x.kind == Vertex::Kind::kThreePlanes &&
      std::find(x.of.begin(), x.of.end(), plane) != x.of.end())
    return Sign::kZero;
  return side(points_of(plane), v);
}

Sign ConvexCells::side_of_crossing(const std::array<Vec3d, 3>& p, std::uint32_t edge,
                                   std::uint32_t crossed) const {
  const CellLine& line = edges_[edge].line;
  if (line.is_explicit) return orient3d(p[0], p[1], p[2], line_plane(line.of, crossed));
  return orient3d(p[0], p[1], p[2], three_planes(line.of, crossed));
}

}  // namespace veritope
