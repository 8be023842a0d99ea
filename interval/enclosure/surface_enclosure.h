// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/surface_enclosure.h: normals and curvatures of a surface in space over a box of parameters.
// Proofs: docs/THEORY.md, ENCLOSE-2. Design, orders of convergence: docs/design/0011-enclosures.md.
#pragma once
#include <array>
#include <optional>

#include "interval/enclosure/spline_enclosure.h"

namespace veritope {

/// S_u x S_v, not normalised: its length is the scale of area. All functions here REQUIRE dimension 3.
/// @error as SplineEnclosure::value; the hull form needs order 1, the mean-value form order 2
Result<Box3> enclose_normal(const SplineEnclosure<2>& surface, const Box2& at,
                            EnclosureForm form = EnclosureForm::kBoth);

/// Curvatures with respect to the normal S_u x S_v / |S_u x S_v|: positive where the surface bends toward it.
struct CurvatureEnclosure {
  Interval gauss, mean;
  Interval principal_min, principal_max;
};
/// Encloses the curvatures at the points with S_u x S_v != 0; usually unbounded where the box may contain other points.
/// @error as enclose_normal, but the hull form needs order 2, the mean-value form order 3
Result<CurvatureEnclosure> enclose_curvatures(const SplineEnclosure<2>& surface, const Box2& at,
                                              EnclosureForm form = EnclosureForm::kBoth);

/// The directions within an angle of an axis: all n with |n x axis| <= tangent (n . axis), tangent >= 0.
struct DirectionCone {
  std::array<double, 3> axis;
  double tangent;
};
/// A cone that contains all normals over the box. Empty if the Bernstein coefficients of the normal's numerator do not
/// all lie inside the half-space that is tried, that of their sum: then the box must be cut, or it has a point without
/// a normal. The numerator is a polynomial vector: S_u x S_v or, for rational maps, (X_u w - X w_u) x (X_v w - X w_v) =
/// w^4 S_u x S_v. The excess of the angle is O(d^2).  @error as enclose_normal; needs order 1
Result<std::optional<DirectionCone>> enclose_normal_cone(const SplineEnclosure<2>& surface,
                                                         const Box2& at);

/// True if it is proved that no direction of a is orthogonal or opposite to one of b; uses the angles' tangents.
/// REQUIRES a live ScopedUpward.
bool are_within_right_angle(const DirectionCone& a, const DirectionCone& b);

}  // namespace veritope
