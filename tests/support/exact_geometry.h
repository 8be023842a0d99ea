// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/exact_geometry.h: points with rational coordinates, and the functions that oracles need for them. Slow;
// shares no line with predicates/.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/base/random.h"
#include "robust/rational.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::oracle {

using RVec = std::array<Rational, 3>;

inline RVec rational(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}
inline RVec operator-(const RVec& a, const RVec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline RVec operator+(const RVec& a, const RVec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline RVec operator*(const Rational& s, const RVec& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline RVec cross(const RVec& a, const RVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational dot(const RVec& a, const RVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline int sgn(const Rational& a) { return to_int(a.sign()); }
inline bool is_zero(const RVec& a) { return sgn(a[0]) == 0 && sgn(a[1]) == 0 && sgn(a[2]) == 0; }

using RTriangle = std::array<RVec, 3>;

inline RTriangle rational_triangle(const TriangleMesh& mesh, std::uint32_t f) {
  const auto& t = mesh.faces[f];
  return {rational(mesh.positions[t[0]]), rational(mesh.positions[t[1]]), rational(mesh.positions[t[2]])};
}
inline RVec normal_of(const RTriangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// The part of the convex hull of `polygon` (in cyclic order) where n.(x - through) >= 0.
inline std::vector<RVec> cut(const std::vector<RVec>& polygon, const RVec& n, const RVec& through) {
  std::vector<Rational> height;
  for (const RVec& p : polygon) height.push_back(dot(n, p - through));
  std::vector<RVec> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (sgn(height[i]) >= 0) out.push_back(polygon[i]);
    if (sgn(height[i]) * sgn(height[j]) < 0)
      out.push_back(polygon[i] + (height[i] / (height[i] - height[j])) * (polygon[j] - polygon[i]));
  }
  return out;
}

/// Whether the closed triangles f and g of the mesh have a common point outside the simplex of their common ids (with
/// three common ids: always). REQUIRES neither degenerate. Method: cuts f with the five half-spaces whose intersection
/// is g.
inline bool meet_improperly(const TriangleMesh& mesh, std::uint32_t f, std::uint32_t g) {
  std::vector<RVec> common;
  for (std::uint32_t v : mesh.faces[f])
    for (std::uint32_t w : mesh.faces[g])
      if (v == w) common.push_back(rational(mesh.positions[v]));
  if (common.size() == 3) return true;
  const RTriangle t = rational_triangle(mesh, f), u = rational_triangle(mesh, g);
  const RVec n = normal_of(u);
  std::vector<RVec> polygon(t.begin(), t.end());
  polygon = cut(polygon, n, u[0]);
  polygon = cut(polygon, Rational(-1) * n, u[0]);
  for (std::size_t i = 0; i < 3; ++i) polygon = cut(polygon, cross(n, u[(i + 1) % 3] - u[i]), u[i]);
  for (const RVec& p : polygon) {
    bool in_common = false;
    if (common.size() == 1) in_common = is_zero(p - common[0]);
    if (common.size() == 2) {
      const RVec e = common[1] - common[0];
      const Rational along = dot(p - common[0], e);
      in_common = is_zero(cross(p - common[0], e)) && sgn(along) >= 0 && along <= dot(e, e);
    }
    if (!in_common) return true;
  }
  return false;
}

/// The sum, over the facets that the ray from p in direction d crosses, of the sign of the crossing (+1: out of the
/// facet's back). nullopt if the ray meets the edge of a facet, or if p lies in a facet.
inline std::optional<int> crossings(const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets, const RVec& p,
                                    const RVec& d) {
  int sum = 0;
  for (std::uint32_t f : facets) {
    const RTriangle t = rational_triangle(mesh, f);
    // Six times the volumes of d with the edges as seen from p: they all have one sign iff the line meets the facet's
    // inside.
    std::array<int, 3> side{};
    for (std::size_t i = 0; i < 3; ++i) side[i] = sgn(dot(d, cross(t[i] - p, t[(i + 1) % 3] - p)));
    const int least = std::min({side[0], side[1], side[2]}), most = std::max({side[0], side[1], side[2]});
    if (least < 0 && most > 0) continue;
    const RVec n = normal_of(t);
    const int slope = sgn(dot(n, d)), ahead = sgn(dot(n, t[0] - p));
    if (least == 0 || most == 0) {  // through an edge or its line, or in the plane: harmless only if it lies behind
      if (slope != 0 && ahead * slope < 0) continue;
      return std::nullopt;
    }
    if (ahead == 0) return std::nullopt;
    if (ahead == slope) sum += slope;
  }
  return sum;
}

/// The winding number of the facets around p, by rays in random directions until one is generic. REQUIRES p in no facet.
inline int winding_number(const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets, const RVec& p, Random& random) {
  for (;;) {
    const RVec d{Rational(random.between(-1000, 1000)), Rational(random.between(-1000, 1000)),
                 Rational(random.between(-1000, 1000))};
    if (is_zero(d)) continue;
    if (const auto w = crossings(mesh, facets, p, d)) return *w;
  }
}

/// The sum of det(a, b, c) / 6. Six times the sum is an integer combination; nothing more is
/// assumed.
inline Rational signed_volume(const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets) {
  Rational sum;
  for (std::uint32_t f : facets) {
    const RTriangle t = rational_triangle(mesh, f);
    sum += dot(t[0], cross(t[1], t[2]));
  }
  return sum / Rational(6);
}

}  // namespace veritope::oracle
