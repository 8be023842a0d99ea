// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/control_gap_internal.h: control points of maps to space as points, and how far those of two maps in one
// function space are apart.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "splines/bspline.h"

namespace veritope::internal {

/// 1 without weights.
template <std::size_t N>
Rational control_weight(const BSpline<Rational, N>& map, std::size_t n) {
  return map.is_rational() ? map.component(map.num_components() - 1)[n] : Rational(1);
}
/// Control point n. REQUIRES a weight that is not 0.
template <std::size_t N>
std::array<Rational, 3> control_point(const BSpline<Rational, N>& map, std::size_t n) {
  std::array<Rational, 3> out{map.component(0)[n], map.component(1)[n], map.component(2)[n]};
  if (!map.is_rational()) return out;
  const Rational& w = map.component(map.num_components() - 1)[n];
  if (w != Rational(1))
    for (Rational& x : out) x /= w;
  return out;
}
/// Moves control point n; its weight stays.
template <std::size_t N>
void set_control_point(BSpline<Rational, N>& map, std::size_t n, const std::array<Rational, 3>& p) {
  const Rational w = control_weight(map, n);
  for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[n] = p[c] * w;
}

/// The largest difference of two coordinates.
inline Rational point_gap(const std::array<Rational, 3>& p, const std::array<Rational, 3>& q) {
  Rational most(0);
  for (std::size_t c = 0; c < 3; ++c)
    if (p[c] != q[c])
      if (Rational d = abs(p[c] - q[c]); d > most) most = d;
  return most;
}

/// The largest difference of two coordinates of control points with one number; nothing if the weights differ by more
/// than a factor. REQUIRES maps in one function space.
template <std::size_t N>
std::optional<Rational> control_gap(const BSpline<Rational, N>& a, const BSpline<Rational, N>& b) {
  const std::size_t count = a.grid().count();
  if (a.is_rational() || b.is_rational()) {
    const Rational v = control_weight(a, 0), w = control_weight(b, 0);
    for (std::size_t n = 1; n < count; ++n)
      if (control_weight(a, n) * w != control_weight(b, n) * v) return std::nullopt;
  }
  Rational most(0);
  for (std::size_t n = 0; n < count; ++n)
    if (Rational d = point_gap(control_point(a, n), control_point(b, n)); d > most) most = d;
  return most;
}

}  // namespace veritope::internal
