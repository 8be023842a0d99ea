// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/vec.h: points with binary64 coordinates; plain data, no arithmetic. Predicates and meshes take Vec3d,
// whose coordinates have names as in their formulas; code that runs over the axes takes Point3d.
#pragma once
#include "robust/base/box3d.h"

namespace veritope {

struct Vec2d {
  double x = 0, y = 0;
  friend bool operator==(const Vec2d&, const Vec2d&) =
      default;  // NOT COVERED: the compiler counts no outcome false
};

struct Vec3d {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3d&, const Vec3d&) =
      default;  // NOT COVERED: the compiler counts no outcome false
  /// Coordinate 0, 1 or 2.
  double operator[](int axis) const { return axis == 0 ? x : (axis == 1 ? y : z); }
};
inline Point3d to_point(const Vec3d& p) { return {p.x, p.y, p.z}; }

}  // namespace veritope
