// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/session.h"

#include <algorithm>

#include "robust/base/fp_guard.h"

namespace veritope {

// The bound of a filter grows with the absolute values of the differences of coordinates, rounding included; none is
// greater than the rounded extent of the box. It is computed in the default environment, because a session may be made
// in one thread and used in another.

Session2d::Session2d(Vec2d lo, Vec2d hi) : lo_(lo), hi_(hi) {
  VT_CHECK(lo.x <= hi.x && lo.y <= hi.y, "a session needs a box with lo <= hi");
  refresh_fp();
  const ScopedDefaultFp nearest;
  const double x = hi.x - lo.x, y = hi.y - lo.y;
  orient_error_ =
      internal::orient2d_error(formulas::Orient2d<FilterReal>(0, 0, x, y, x, y), kFilterFloor);
  circle_error_ = internal::in_circle_error(formulas::InCircle<FilterReal>(x, y, x, y, x, y, 0, 0),
                                            kFilterFloor);
}

Session3d::Session3d(const Vec3d& lo, const Vec3d& hi) : lo_(lo), hi_(hi) {
  VT_CHECK(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z, "a session needs a box with lo <= hi");
  refresh_fp();
  const ScopedDefaultFp nearest;
  const double x = hi.x - lo.x, y = hi.y - lo.y, z = hi.z - lo.z;
  orient_error_ = internal::orient3d_error(formulas::Plane3<FilterReal>(0, 0, 0, x, y, z, x, y, z),
                                           x, y, z, kFilterFloor);
  sphere_error_ = internal::in_sphere_error(x, y, z, kFilterFloor);
}

Session2d Session2d::around(const Vec2d* points, std::size_t n) {
  Vec2d lo = n == 0 ? Vec2d{} : points[0], hi = lo;
  const auto widen = [&] {
    const ScopedDefaultFp nearest;  // comparisons, too, depend on DAZ
    for (std::size_t i = 1; i < n; ++i) {
      lo = {std::min(lo.x, points[i].x), std::min(lo.y, points[i].y)};
      hi = {std::max(hi.x, points[i].x), std::max(hi.y, points[i].y)};
    }
  };
  widen();
  return Session2d(lo, hi);
}

Session3d Session3d::around(const Vec3d* points, std::size_t n) {
  Vec3d lo = n == 0 ? Vec3d{} : points[0], hi = lo;
  const auto widen = [&] {
    const ScopedDefaultFp nearest;
    for (std::size_t i = 1; i < n; ++i) {
      const Vec3d& p = points[i];
      lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
      hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
  };
  widen();
  return Session3d(lo, hi);
}

}  // namespace veritope
