// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier_degree.h: Bezier maps with higher degrees.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/bezier.h"
#include "splines/binomial.h"
#include "splines/lines.h"

namespace veritope {

/// Raises the degree along `axis` by `by`; the map stays the same. Each new coefficient is a convex combination of old
/// ones. REQUIRES by >= 0.  @cost (degree + 1)(by + 1) products per line.  @source [FR88]
template <Ring R, std::size_t N>
Bezier<R, N> elevate(const Bezier<R, N>& map, std::size_t axis, int by) {
  VT_CHECK(by >= 0, "a degree can only be raised");
  if (by == 0) return map;
  const int p = map.degree(axis);
  std::vector<R> weights;  // of old coefficient i in new i + j
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= by; ++j) weights.push_back(product_weight<R>(p, i, by, j));
  auto degrees = map.degrees();
  degrees[axis] += by;
  const auto rows = static_cast<std::size_t>(p) + 1, columns = static_cast<std::size_t>(by) + 1;
  return {degrees, map.num_components(), map.is_rational(),
          internal::map_lines(map, axis, rows + columns - 1, [&](auto from, auto to) {
            for (std::size_t i = 0; i < rows; ++i)
              for (std::size_t j = 0; j < columns; ++j)
                internal::accumulate(to[i + j], weights[i * columns + j] * from[i]);
          })};
}

/// Raises the degrees to the given ones; the map stays the same. REQUIRES that none is below the map's.
template <Ring R, std::size_t N>
Bezier<R, N> elevate_to(Bezier<R, N> map, const std::array<int, N>& degrees) {
  for (std::size_t axis = 0; axis < N; ++axis)
    map = elevate(map, axis, degrees[axis] - map.degree(axis));
  return map;
}

/// Both maps with the greater degree along each axis. Polynomial maps are equal iff their coefficients then are equal;
/// rational maps are equal if their coefficients then are equal up to one factor.
template <Ring R, std::size_t N>
std::pair<Bezier<R, N>, Bezier<R, N>> to_common_degrees(const Bezier<R, N>& a,
                                                        const Bezier<R, N>& b) {
  std::array<int, N> degrees;
  for (std::size_t i = 0; i < N; ++i) degrees[i] = std::max(a.degree(i), b.degree(i));
  return {elevate_to(a, degrees), elevate_to(b, degrees)};
}

// Compiled once, in rational_instances.cc.
extern template Bezier<Rational, 1> elevate(const Bezier<Rational, 1>&, std::size_t, int);
extern template Bezier<Rational, 2> elevate(const Bezier<Rational, 2>&, std::size_t, int);
extern template Bezier<Rational, 3> elevate(const Bezier<Rational, 3>&, std::size_t, int);

}  // namespace veritope
