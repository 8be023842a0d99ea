// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier_calculus.h: derivatives and integrals of Bezier maps.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "robust/base/check.h"
#include "splines/bezier.h"
#include "splines/bezier_components.h"
#include "splines/bezier_product.h"
#include "splines/lines.h"

namespace veritope {

/// The derivative along `axis`. For a polynomial map its degree along the axis is one lower (0 from degree 0). For a
/// rational map it is (w P' - w' P) / w^2, with twice the degrees and the squared weight.
template <Ring R, std::size_t N>
Bezier<R, N> derivative(const Bezier<R, N>& map, std::size_t axis) {
  if (map.is_rational()) {
    const auto p = numerators(map), w = weight(map);
    return quotient(
        difference(multiplied(w, derivative(p, axis)), multiplied(derivative(w, axis), p)),
        multiplied(w, w));
  }
  auto degrees = map.degrees();
  const int n = degrees[axis];
  degrees[axis] = std::max(n - 1, 0);
  const R factor = RingNumbers<R>::ratio(n, 1);
  return {degrees, map.num_components(), false,
          internal::map_lines(map, axis, static_cast<std::size_t>(degrees[axis]) + 1,
                              [&](auto from, auto to) {
                                for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
                                  to[i] = factor * (from[i + 1] - from[i]);
                              })};
}

/// The integral along `axis` from 0 to its variable, with a degree one higher. REQUIRES a polynomial map.
template <Ring R, std::size_t N>
Bezier<R, N> antiderivative(const Bezier<R, N>& map, std::size_t axis) {
  VT_CHECK(!map.is_rational(), "integral of a rational map");
  auto degrees = map.degrees();
  const auto n = static_cast<std::size_t>(++degrees[axis]);
  const R factor = RingNumbers<R>::ratio(1, degrees[axis]);
  return {degrees, map.num_components(), false,
          internal::map_lines(map, axis, n + 1, [&](auto from, auto to) {
            R total = R();
            for (std::size_t i = 1; i <= n; ++i) {
              internal::accumulate(total, from[i - 1]);
              to[i] = factor * total;
            }
          })};
}

/// The integrals of the components over [0,1]^N: the means of their coefficients. REQUIRES a polynomial map.
template <Ring R, std::size_t N>
std::vector<R> integral(const Bezier<R, N>& map) {
  VT_CHECK(!map.is_rational(), "integral of a rational map");
  std::vector<R> integrals;
  for (int c = 0; c < map.num_components(); ++c) {
    R total = R();
    for (const R& v : map.component(c)) internal::accumulate(total, v);
    for (const int degree : map.degrees()) total = total * RingNumbers<R>::ratio(1, degree + 1);
    integrals.push_back(total);
  }
  return integrals;
}

}  // namespace veritope
