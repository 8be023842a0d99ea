// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/tetrahedra/boundary_classes.h: corners, curves and smooth parts of a domain's boundary, and feature lines.
// Source: [HHQ04], section 5.2; what differs from it is said at each function.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/exact_point.h"
#include "robust/rational.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

enum class VertexClass {
  kInterior,  ///< not on the boundary, or no corner of a tetrahedron
  kSmooth,    ///< "general" in the paper
  kCurve,
  kCorner,
};
/// "interior", "smooth", "curve", "corner"
const char* class_name(VertexClass c);

/// The solid angles of the tetrahedra at each vertex of the boundary, added up, rounded; 4 pi at others.
std::vector<double> approx_solid_angles(std::span<const ExactPoint3> points,
                                        const TetrahedralComplex& complex);

/// The paper's rule: a corner up to pi / 2, a curve up to 3 pi / 2, the same for 4 pi less the angle; else smooth. An
/// angle within 2^-40 of a limit counts as the limit: angles are rounded, and those of cubes lie on the limits.
/// REQUIRES a vertex of the boundary. (A corner where three octants meet is a "curve" by this rule.)
VertexClass class_by_solid_angle(double solid_angle);

/// Two vertices in ascending order: edges of the boundary whose two faces have normals that enclose more than the
/// angle, from 0 to a right one, whose squared cosine is given. Exact. Ascending.
/// REQUIRES a complex whose boundary is a 2-manifold.
std::vector<std::array<std::uint32_t, 2>> feature_edges(std::span<const ExactPoint3> points,
                                                        const TetrahedralComplex& complex,
                                                        const Rational& squared_cosine);

/// The class of each vertex by feature edges: smooth without one, a curve with exactly two that turn by no more than
/// the angle, else a corner. Exact.
std::vector<VertexClass> classes_by_features(std::span<const ExactPoint3> points,
                                             const TetrahedralComplex& complex,
                                             std::span<const std::array<std::uint32_t, 2>> edges,
                                             const Rational& squared_cosine);

/// The feature edges as lines from corner to corner, then closed ones without a corner, whose first vertex is their
/// last. Each edge is in one line. Lines begin at their lesser end, closed ones at their least vertex, and are in
/// ascending order.
std::vector<std::vector<std::uint32_t>> feature_lines(
    std::span<const std::array<std::uint32_t, 2>> edges, std::span<const VertexClass> classes);

}  // namespace veritope
