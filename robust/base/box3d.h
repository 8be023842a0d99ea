// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/box3d.h: points and closed boxes of doubles.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace veritope {

using Point3d = std::array<double, 3>;
/// A closed box. No side is NaN.
struct Box3d {
  Point3d lo, hi;
};
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
