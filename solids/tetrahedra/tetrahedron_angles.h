// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/tetrahedra/tetrahedron_angles.h: dihedral and solid angles of tetrahedra, rounded: for reports, no decisions.
// Source: [OS83].
#pragma once
#include <array>
#include <cstddef>

#include "predicates/exact_point.h"
#include "robust/base/box3d.h"

namespace veritope {

/// The corners of a tetrahedron relative to the first one, scaled so that the largest coordinate is near 1.
using TetrahedronShape = std::array<Point3d, 4>;
TetrahedronShape shape_of(const std::array<const ExactPoint3*, 4>& corners);

/// The least of the six angles between its facets, in radians.
double approx_min_dihedral(const TetrahedronShape& tetrahedron);

/// The solid angle at a corner, from 0 to 2 pi: twice the arctangent, of two arguments, of the triple product of the
/// edges' directions a, b, c and 1 + a.b + b.c + c.a. (The arcsine of [LJ94], which [HHQ04] uses, is that of half an
/// angle up to pi only.)
double approx_solid_angle(const TetrahedronShape& tetrahedron, std::size_t corner);

}  // namespace veritope
