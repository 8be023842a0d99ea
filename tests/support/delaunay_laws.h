// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/delaunay_laws.h: whether tetrahedra are a Delaunay tetrahedralization, by its definition and exactly.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "predicates/exact_in_sphere.h"
#include "predicates/exact_point.h"
#include "predicates/in_sphere.h"
#include "predicates/orient3d.h"
#include "robust/rational.h"
#include "solids/tetrahedra/delaunay.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

/// Each set of corners once, sorted: for comparisons.
inline std::vector<TetrahedronCorners> sorted_tetrahedra(
    std::vector<TetrahedronCorners> tetrahedra) {
  for (TetrahedronCorners& t : tetrahedra) std::sort(t.begin(), t.end());
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

namespace internal {

inline Rational exact_det(const std::array<Vec3d, 4>& p) {
  std::array<std::array<Rational, 3>, 3> d;
  for (std::size_t i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis)
      d[i][static_cast<std::size_t>(axis)] =
          Rational::from_double(p[i + 1][axis]) - Rational::from_double(p[0][axis]);
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

template <typename Point>
std::string check_complex(std::span<const Point> points, const DelaunayTetrahedra& result,
                          const TetrahedralComplex& complex) {
  if (!complex.overused().empty()) return "a face has more than two tetrahedra, or two of one side";
  if (complex.euler() != 1) return "Euler characteristic " + std::to_string(complex.euler());
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const LinkKind link = classify_link(complex.link(v));
    const bool is_corner = result.same_as[v] == v;
    if (is_corner ? link != LinkKind::kClosed && link != LinkKind::kOpen : link != LinkKind::kEmpty)
      return "the link of vertex " + std::to_string(v);
  }
  return "";
}

// The neighbour across each edge of the boundary is on no outer side of a triangle; and with `all`, no point is.
template <typename Point>
std::string check_hull(std::span<const Point> points, const TetrahedralComplex& complex, bool all) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> opposite;
  const auto boundary = complex.boundary();
  for (const TetrahedronFace f : boundary) {
    const auto v = complex.vertices(f);
    for (std::size_t i = 0; i < 3; ++i)
      if (!opposite.insert({{v[i], v[(i + 1) % 3]}, v[(i + 2) % 3]}).second)
        return "an edge of the hull";
  }
  for (const TetrahedronFace f : boundary) {
    const auto v = complex.vertices(f);
    // Seen from outside the triangle turns counter-clockwise: orient3d is positive on the outer side.
    const auto is_outside = [&](std::uint32_t p) {
      return orient3d(points[v[0]], points[v[1]], points[v[2]], points[p]) == Sign::kPositive;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const auto across = opposite.find({v[(i + 1) % 3], v[i]});
      if (across == opposite.end()) return "the hull is not closed";
      if (is_outside(across->second)) return "the boundary is not convex";
    }
    for (std::uint32_t p = 0; all && p < points.size(); ++p)
      if (is_outside(p)) return "point " + std::to_string(p) + " is outside of the hull";
  }
  return "";
}

}  // namespace internal

/// The law that does not hold, or "". With `all`, each sphere and each plane of the hull is tested with each point;
/// else with the next ones, which suffices.
template <typename Point>
std::string check_delaunay(std::span<const Point> points, const DelaunayTetrahedra& result,
                           bool all) {
  const auto at = [&](std::uint32_t v) -> const Point& { return points[v]; };
  for (const TetrahedronCorners& t : result.tetrahedra)
    if (orient3d(at(t[0]), at(t[1]), at(t[2]), at(t[3])) != Sign::kPositive)
      return "a tetrahedron is flat or reversed";
  const auto num_vertices = static_cast<std::uint32_t>(points.size());
  const TetrahedralComplex complex(result.tetrahedra, num_vertices);
  if (std::string law = internal::check_complex(points, result, complex); !law.empty()) return law;
  if (std::string law = internal::check_hull(points, complex, all); !law.empty()) return law;
  for (std::uint32_t t = 0; t < result.tetrahedra.size(); ++t) {
    const TetrahedronCorners& c = result.tetrahedra[t];
    const auto is_inside = [&](std::uint32_t p) {
      return in_sphere(at(c[0]), at(c[1]), at(c[2]), at(c[3]), at(p)) == Sign::kPositive;
    };
    for (std::uint32_t m = 0; m < 4; ++m) {
      const auto partner = complex.partner(4 * t + m);
      if (partner &&
          is_inside(result.tetrahedra[face_tetrahedron(*partner)][face_corner(*partner)]))
        return "a sphere is not empty";
    }
    for (std::uint32_t p = 0; all && p < points.size(); ++p)
      if (is_inside(p)) return "a sphere contains point " + std::to_string(p);
  }
  return "";
}

/// Whether the volumes of the tetrahedra add up to that of the pyramids from a point over the triangles of the
/// boundary, none of which is negative.
inline bool volumes_add_up(std::span<const Vec3d> points, const DelaunayTetrahedra& result) {
  const TetrahedralComplex complex(result.tetrahedra, static_cast<std::uint32_t>(points.size()));
  Rational inside, pyramids;
  for (const TetrahedronCorners& t : result.tetrahedra)
    inside += internal::exact_det({points[t[0]], points[t[1]], points[t[2]], points[t[3]]});
  for (const TetrahedronFace f : complex.boundary()) {
    const auto v = complex.vertices(f);
    const Rational pyramid =
        internal::exact_det({points[0], points[v[0]], points[v[1]], points[v[2]]});
    if (pyramid.sign() == Sign::kNegative) return false;
    pyramids += pyramid;
  }
  return inside == pyramids;
}

/// "{x, y, z}, ..." in hexadecimal, for a test.
inline std::string to_text(std::span<const Vec3d> points) {
  std::string out;
  for (const Vec3d& p : points) {
    std::array<char, 100> text{};
    std::snprintf(text.data(), text.size(), "{%a, %a, %a}, ", p.x, p.y, p.z);
    out += text.data();
  }
  return out;
}

}  // namespace veritope
