// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/box_geometry.h: vectors of intervals in space, and approximate middles and radii that guide searches.
#pragma once
#include <array>
#include <cstddef>

#include "interval/box.h"

namespace veritope::internal {

/// Approximate: no proof may rely on these values, and they need no particular rounding mode.
inline double approx_middle(const Interval& a) { return 0.5 * a.lo() + 0.5 * a.hi(); }
template <std::size_t N>
std::array<double, N> approx_middle(const Box<N>& x) {
  std::array<double, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = approx_middle(x[i]);
  return out;
}
inline double approx_radius(const Interval& a) { return 0.5 * a.hi() - 0.5 * a.lo(); }

// Enclosures; all REQUIRE a live ScopedUpward.
inline Interval dot(const Box3& a, const Box3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Box3 cross(const Box3& a, const Box3& b) {
  return Box3(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}
inline Interval norm(const Box3& v) { return sqrt(sqr(v[0]) + sqr(v[1]) + sqr(v[2])); }

}  // namespace veritope::internal
