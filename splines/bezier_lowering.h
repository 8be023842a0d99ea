// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier_lowering.h: Bezier maps with lower degrees, where that changes nothing.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "robust/base/check.h"
#include "robust/rational.h"
#include "splines/bezier.h"
#include "splines/lines.h"

namespace veritope {

/// Lowers the degree along the axis by 1 if the map can be written so. REQUIRES a degree of at least 1.
/// A rational map is taken as homogeneous polynomials: a common factor of these is not found.
/// @source [FR88], solved for the old coefficients: p c_i = i b_(i-1) + (p - i) b_i
/// @cost  2 products for each coefficient
template <std::size_t N>
std::optional<Bezier<Rational, N>> lower(const Bezier<Rational, N>& map, std::size_t axis) {
  const int p = map.degree(axis);
  VT_CHECK(p >= 1, "there is no degree to lower");
  auto degrees = map.degrees();
  --degrees[axis];
  bool is_exact = true;
  Bezier<Rational, N> out(
      degrees, map.num_components(), map.is_rational(),
      internal::map_lines(map, axis, static_cast<std::size_t>(p), [&](auto from, auto to) {
        if (!is_exact) return;
        to[0] = from[0];
        for (int i = 1; i < p; ++i) {
          const auto k = static_cast<std::size_t>(i);
          to[k] = (Rational(p) * from[k] - Rational(i) * to[k - 1]) / Rational(p - i);
        }
        const auto last = static_cast<std::size_t>(p);
        is_exact = to[last - 1] == from[last];
      }));
  if (!is_exact) return std::nullopt;
  return out;
}

/// Lowers the degrees as far as the map stays the same, but none below 1. The order of the axes does not
/// matter. REQUIRES degrees of at least 1.
template <std::size_t N>
Bezier<Rational, N> lowered(Bezier<Rational, N> map) {
  for (std::size_t axis = 0; axis < N; ++axis)
    while (map.degree(axis) > 1) {
      auto less = lower(map, axis);
      if (!less) break;
      map = std::move(*less);
    }
  return map;
}

}  // namespace veritope
