// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier_domain.h: Bezier maps on parts of their domain, with axes reversed, permuted or fixed.
#pragma once
#include <array>
#include <cstddef>
#include <utility>

#include "robust/base/check.h"
#include "splines/bezier.h"
#include "splines/de_casteljau.h"
#include "splines/lines.h"
#include "splines/restriction.h"

namespace veritope {

/// The map on the part [a, b] of `axis`, as a map of [0,1]^N. Coefficients are convex combinations of the old ones if
/// [a, b] lies in [0, 1]; elsewhere it extrapolates. REQUIRES a < b.  @cost degree^2 blends per line
template <Ring R, std::size_t N>
Bezier<R, N> restricted(Bezier<R, N> map, std::size_t axis, const typename RingNumbers<R>::Knot& a,
                        const typename RingNumbers<R>::Knot& b) {
  using Numbers = RingNumbers<R>;
  using Knot = typename Numbers::Knot;
  VT_CHECK(a < b, "a part of the domain needs a begin below its end");
  const internal::OrderOfCuts order = internal::order_of_cuts(a, b);
  const internal::CutPlaces<Knot> places(a, b, Knot(1), order.end_first);
  const internal::PartCuts<internal::AffineBlend<R>> cuts{
      order, internal::cut_at(Numbers::of_knot(places.begin)),
      internal::cut_at(Numbers::of_knot(places.end))};
  internal::on_lines(map, axis, [&](R* first, std::size_t stride) {
    cuts.apply(first, stride, map.degree(axis));
  });
  return map;
}

/// u -> F(1 - u) along `axis`.
template <Ring R, std::size_t N>
Bezier<R, N> reversed(const Bezier<R, N>& map, std::size_t axis) {
  const auto n = static_cast<std::size_t>(map.degree(axis));
  return {map.degrees(), map.num_components(), map.is_rational(),
          internal::map_lines(map, axis, n + 1, [n](auto from, auto to) {
            for (std::size_t i = 0; i <= n; ++i) to[i] = from[n - i];
          })};
}

/// The map with its variables in another order: new axis i is old axis order[i]. REQUIRES a permutation.
template <Ring R, std::size_t N>
Bezier<R, N> permuted(const Bezier<R, N>& map, const std::array<std::size_t, N>& order) {
  return {internal::permuted(map.degrees(), order), map.num_components(), map.is_rational(),
          internal::permuted_net(map.coefficients(), map.grid(), order)};
}
/// Two axes exchanged.
template <Ring R, std::size_t N>
Bezier<R, N> swapped(const Bezier<R, N>& map, std::size_t axis, std::size_t other) {
  std::array<std::size_t, N> order;
  for (std::size_t i = 0; i < N; ++i) order[i] = i;
  std::swap(order[axis], order[other]);
  return permuted(map, order);
}

/// The map in the other variables, with that of `axis` fixed at t. @cost degree^2 / 2 blends per line
template <Ring R, std::size_t N>
requires(N > 1) Bezier<R, N - 1> isoparametric(Bezier<R, N> map, std::size_t axis, const R& t) {
  const auto blend = internal::cut_at(t);
  internal::on_lines(map, axis, [&](R* first, std::size_t stride) {
    internal::keep_right(first, stride, map.degree(axis), blend);
  });
  return boundary(map, axis, 0);
}
/// The map in the other variables, with that of `axis` fixed at 0 (end = 0) or 1 (end = 1): coefficients are copied.
template <Ring R, std::size_t N>
requires(N > 1) Bezier<R, N - 1> boundary(const Bezier<R, N>& map, std::size_t axis, int end) {
  const auto at = end == 0 ? 0 : static_cast<std::size_t>(map.degree(axis));
  return {internal::without_axis(map.degrees(), axis), map.num_components(), map.is_rational(),
          internal::map_lines(map, axis, 1, [at](auto from, auto to) { to[0] = from[at]; })};
}

}  // namespace veritope
