// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/box3d.h: points and closed boxes of doubles: plain data, which every room may hold.
// Which point: Point3d where code runs over the axes (boxes, trees, searches, pictures); Vec3d (predicates/vec.h) where
// formulas name x, y and z (predicates, meshes). Which box: Box3d for bounds that are compared; Box3 (interval/box.h)
// for sets that are computed with, rounded outward; ExactBox (interval/exact_box.h) where no rounding is allowed.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace veritope {

using Point3d = std::array<double, 3>;
/// A closed box. No bound is NaN. A box without points has lo = +infinity, hi = -infinity.
struct Box3d {
  Point3d lo, hi;
  friend bool operator==(const Box3d&, const Box3d&) = default;
};
inline Box3d empty_box() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}
inline bool meets(const Box3d& a, const Box3d& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.hi[k] < b.lo[k] || b.hi[k] < a.lo[k]) return false;
  return true;
}
inline bool is_inside(const Box3d& a, const Box3d& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.lo[k] < b.lo[k] || b.hi[k] < a.hi[k]) return false;
  return true;
}
inline Box3d hull(const Box3d& a, const Box3d& b) {
  Box3d out = a;
  for (std::size_t k = 0; k < 3; ++k) {
    if (b.lo[k] < out.lo[k]) out.lo[k] = b.lo[k];
    if (out.hi[k] < b.hi[k]) out.hi[k] = b.hi[k];
  }
  return out;
}
/// The box grows to hold the point.
inline void add(const Point3d& p, Box3d* box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (p[k] < box->lo[k]) box->lo[k] = p[k];
    if (box->hi[k] < p[k]) box->hi[k] = p[k];
  }
}
/// The points that both boxes contain. REQUIRES meets(a, b).
inline Box3d common(const Box3d& a, const Box3d& b) {
  Box3d out = a;
  for (std::size_t k = 0; k < 3; ++k) {
    if (out.lo[k] < b.lo[k]) out.lo[k] = b.lo[k];
    if (b.hi[k] < out.hi[k]) out.hi[k] = b.hi[k];
  }
  return out;
}
/// Whether all its bounds are finite.
inline bool is_finite(const Box3d& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!std::isfinite(b.lo[k]) || !std::isfinite(b.hi[k])) return false;
  return true;
}
/// The axis of the longest side, the first of several.
inline std::size_t longest_axis(const Box3d& b) {
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (b.hi[axis] - b.lo[axis] < b.hi[k] - b.lo[k]) axis = k;
  return axis;
}
/// The length of the longest side.
inline double extent(const Box3d& b) {
  double e = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (e < b.hi[k] - b.lo[k]) e = b.hi[k] - b.lo[k];
  return e;
}
/// The middle, rounded.
inline Point3d approx_centre(const Box3d& b) {
  return {0.5 * b.lo[0] + 0.5 * b.hi[0], 0.5 * b.lo[1] + 0.5 * b.hi[1],
          0.5 * b.lo[2] + 0.5 * b.hi[2]};
}

}  // namespace veritope
