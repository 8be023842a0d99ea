// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/projection.h: a plane in space seen along a coordinate axis; lines on one plane stay
// lines, and nothing is rounded.
#pragma once
#include "predicates/orient2d.h"
#include "predicates/vec.h"

namespace veritope {

/// p without its coordinate `axis` (0, 1 or 2), in the cyclic order that keeps the orientation:
/// (y,z), (z,x) or (x,y).
constexpr Vec2d drop_axis(const Vec3d& p, int axis) {
  return axis == 0 ? Vec2d{p.y, p.z} : (axis == 1 ? Vec2d{p.z, p.x} : Vec2d{p.x, p.y});
}

/// An axis along which a, b, c are not seen as a line, and how they turn there; sign kZero iff a,
/// b, c lie on one line in space.
struct AxisProjection {
  int axis;
  Sign sign;  ///< of orient2d of the three projected points
};
/// REQUIRES finite coordinates.
AxisProjection projection_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept;

/// Do a, b, c lie on one line (or point)? Exact. REQUIRES finite coordinates.
inline bool collinear(const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept {
  return projection_of(a, b, c).sign == Sign::kZero;
}

}  // namespace veritope
