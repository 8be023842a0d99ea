// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/pn_triangle.h: the cubic patch and the quadratic normal field over a triangle with normals at its corners
// [VPBM01], as seed 001 uses them [GRF03], section 3.1; exactly in rationals, without square roots.
#pragma once
#include <array>

#include "robust/base/result.h"
#include "splines/bezier_triangle.h"

namespace veritope {

using PnPoint = std::array<Rational, 3>;

/// points: degree 3. It interpolates the corners, where its tangent planes are orthogonal to the normals; its boundary
/// over an edge depends on that edge's ends and their normals only. The lengths of the normals do not matter.
/// normals: degree 2, not normalised. It has the given normals, with their lengths, at the corners; over an edge it
/// depends on the edge alone. It is not the normal of `points`, but resembles it. [VPBM01] normalises all coefficients:
/// the middle coefficient of an edge here is theirs times the cosine of half the angle between the two normals if these
/// are of length 1, so that no root is needed.
struct PnTriangle {
  BezierTriangle<Rational> points;
  BezierTriangle<Rational> normals;
};

/// @error kBadArgument: a degenerate triangle; a normal that is zero, or 90 degrees or more off the triangle's plane
///        normal (p1 - p0) x (p2 - p0), with the corner, from 0, as Place::vertex.
Result<PnTriangle> make_pn_triangle(const std::array<PnPoint, 3>& corners,
                                    const std::array<PnPoint, 3>& normals);

/// Corners and normals in any exact numbers: Rational, or Dyadic, which is faster where the input is binary64.
template <typename S>
struct PnCorners {
  std::array<std::array<S, 3>, 3> points, normals;
};
/// What make_pn_triangle refuses.
template <typename S>
Status check_pn_triangle(const PnCorners<S>& corners);
/// The control point next to p of the edge from p to q: (2p + q - ((q - p).n) n / (n.n)) / 3. REQUIRES n not zero.
template <typename S>
PnPoint pn_edge_point(const std::array<S, 3>& p, const std::array<S, 3>& q,
                      const std::array<S, 3>& n);
/// The middle coefficient of an edge's normals: half of n + m, reflected in the plane across the edge,
/// (n + m) / 2 - (d.(n + m) / (d.d)) d for d = q - p. Symmetric. REQUIRES p != q.
template <typename S>
PnPoint pn_edge_normal(const std::array<S, 3>& p, const std::array<S, 3>& q,
                       const std::array<S, 3>& n, const std::array<S, 3>& m);
/// The centre: E + (E - V) / 2 for the means E of the six edge points and V of the corners. REQUIRES no normal zero.
template <typename S>
PnPoint pn_centre(const PnCorners<S>& corners);

/// The forms from their coefficients, over any ring. edge_points[e] belongs to the edge opposite to corner e: first the
/// point next to corner e + 1, then the one next to corner e + 2 (modulo 3). edge_normals[e] belongs to that edge.
template <Ring R>
BezierTriangle<R> pn_points(const std::array<std::array<R, 3>, 3>& corners,
                            const std::array<std::array<std::array<R, 3>, 2>, 3>& edge_points,
                            const std::array<R, 3>& centre) {
  BezierTriangle<R> map(3, 3, false);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::span<R> b = map.component(static_cast<int>(c));
    const auto set = [&](int j, int k, const std::array<R, 3>& p) {
      b[triangle_index(j, k)] = p[c];
    };
    set(0, 0, corners[0]), set(3, 0, corners[1]), set(0, 3, corners[2]);
    set(2, 1, edge_points[0][0]), set(1, 2, edge_points[0][1]);
    set(0, 2, edge_points[1][0]), set(0, 1, edge_points[1][1]);
    set(1, 0, edge_points[2][0]), set(2, 0, edge_points[2][1]);
    set(1, 1, centre);
  }
  return map;
}
template <Ring R>
BezierTriangle<R> pn_normals(const std::array<std::array<R, 3>, 3>& corner_normals,
                             const std::array<std::array<R, 3>, 3>& edge_normals) {
  BezierTriangle<R> map(2, 3, false);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::span<R> b = map.component(static_cast<int>(c));
    b[triangle_index(0, 0)] = corner_normals[0][c];
    b[triangle_index(2, 0)] = corner_normals[1][c];
    b[triangle_index(0, 2)] = corner_normals[2][c];
    b[triangle_index(1, 1)] = edge_normals[0][c];
    b[triangle_index(0, 1)] = edge_normals[1][c];
    b[triangle_index(1, 0)] = edge_normals[2][c];
  }
  return map;
}

}  // namespace veritope
