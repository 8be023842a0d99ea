// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier_components.h: maps made of components of other maps.
#pragma once
#include <cstddef>
#include <vector>

#include "robust/base/check.h"
#include "splines/bezier.h"
#include "splines/bezier_degree.h"

namespace veritope {

/// The polynomial map of the components first, ..., first + count - 1; a weight counts as one.
template <Ring R, std::size_t N>
Bezier<R, N> components(const Bezier<R, N>& map, int first, int count) {
  VT_CHECK(first >= 0 && count >= 0 && first + count <= map.num_components(),
           "components that the map does not have");
  const std::size_t size = map.grid().count();
  const auto begin = map.coefficients().begin() +
                     static_cast<std::ptrdiff_t>(size * static_cast<std::size_t>(first));
  return {map.degrees(), count, false,
          std::vector<R>(
              begin, begin + static_cast<std::ptrdiff_t>(size * static_cast<std::size_t>(count)))};
}
/// The components without the weight; in a rational map they are the weight times the coordinates.
template <Ring R, std::size_t N>
Bezier<R, N> numerators(const Bezier<R, N>& map) {
  return components(map, 0, map.dimension());
}
/// The weight; the polynomial 1 if the map is not rational.
template <Ring R, std::size_t N>
Bezier<R, N> weight(const Bezier<R, N>& map) {
  if (map.is_rational()) return components(map, map.dimension(), 1);
  return {{}, 1, false, std::vector<R>{one<R>()}};
}

/// The components of a and then those of b, brought to common degrees. REQUIRES polynomial maps.
template <Ring R, std::size_t N>
Bezier<R, N> joined(const Bezier<R, N>& a, const Bezier<R, N>& b, bool is_rational = false) {
  VT_CHECK(!a.is_rational() && !b.is_rational(), "components of rational maps share their weight");
  const auto [first, second] = to_common_degrees(a, b);
  std::vector<R> all(first.coefficients().begin(), first.coefficients().end());
  all.insert(all.end(), second.coefficients().begin(), second.coefficients().end());
  return {first.degrees(), a.num_components() + b.num_components(), is_rational, std::move(all)};
}
/// The rational map numerators / weight. REQUIRES polynomial maps, the second with one component.
template <Ring R, std::size_t N>
Bezier<R, N> quotient(const Bezier<R, N>& numerators, const Bezier<R, N>& weight) {
  VT_CHECK(weight.num_components() == 1, "a rational map has one weight");
  return joined(numerators, weight, true);
}
/// Converts the map to homogeneous form: with the weight 1 if it is polynomial.
template <Ring R, std::size_t N>
Bezier<R, N> to_rational(const Bezier<R, N>& map) {
  return map.is_rational() ? map : quotient(map, weight(map));
}

}  // namespace veritope
