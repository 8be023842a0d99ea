// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline_domain.h: B-splines on parts of their domain, clamped, reversed, with axes permuted, on other
// domains.
#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "splines/bspline.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"
#include "splines/lines.h"

namespace veritope {
namespace internal {

/// The part [a, b] of the domain, clamped. REQUIRES a < b in the domain.
template <Ring R, std::size_t N>
BSpline<R, N> clamped_part(BSpline<R, N> map, std::size_t axis,
                           const typename RingNumbers<R>::Knot& a,
                           const typename RingNumbers<R>::Knot& b) {
  map = refine(map, axis, missing_knots(map.axis(axis), {a, b}));
  const auto& old_axis = map.axis(axis);
  const auto p = static_cast<std::size_t>(old_axis.degree);
  const auto knots = old_axis.knots.begin();
  const std::size_t span = find_span(old_axis, a);
  const auto past = static_cast<std::size_t>(
      std::lower_bound(knots + static_cast<std::ptrdiff_t>(span), old_axis.knots.end(), b) - knots);
  auto axes = map.axes();
  auto& inner = axes[axis].knots;
  inner.assign(p + 1, a);
  inner.insert(inner.end(), knots + static_cast<std::ptrdiff_t>(span) + 1,
               knots + static_cast<std::ptrdiff_t>(past));
  inner.insert(inner.end(), p + 1, b);
  axes[axis].is_periodic = false;
  const std::size_t first = span - p, count = past - first;
  return BSpline<R, N>(std::move(axes), map.num_components(), map.is_rational(),
                       map_lines(map, axis, count, [first, count](auto from, auto to) {
                         for (std::size_t i = 0; i < count; ++i) to[i] = from[first + i];
                       }));
}

/// The map with other knots, which increase as the old ones do, and the control points in the same or the reverse
/// order.
template <Ring R, std::size_t N>
BSpline<R, N> with_knots(const BSpline<R, N>& map, std::size_t axis,
                         std::vector<typename RingNumbers<R>::Knot> knots, bool reversed) {
  auto axes = map.axes();
  axes[axis].knots = std::move(knots);
  const std::size_t n = map.axis(axis).num_control();
  return BSpline<R, N>(std::move(axes), map.num_components(), map.is_rational(),
                       map_lines(map, axis, n, [n, reversed](auto from, auto to) {
                         for (std::size_t i = 0; i < n; ++i) to[i] = from[reversed ? n - 1 - i : i];
                       }));
}

}  // namespace internal

/// The map on the part [a, b] of the domain of `axis`, clamped: a and b are its first and last degree + 1 knots. Where
/// the map jumps at a or b, the part has the value from inside. @error kBadArgument, with the axis and the value,
/// unless a < b in the domain.
template <Ring R, std::size_t N>
Result<BSpline<R, N>> restricted(const BSpline<R, N>& map, std::size_t axis,
                                 const typename RingNumbers<R>::Knot& a,
                                 const typename RingNumbers<R>::Knot& b) {
  for (const auto& u : {a, b})
    if (const Status in = internal::require_in_domain(map.axis(axis), axis, u); !in)
      return in.error();
  if (!(a < b)) return internal::empty_domain(axis, a, b);
  return internal::clamped_part(map, axis, a, b);
}
/// The map on the box [a[0], b[0]] x [a[1], b[1]] x ...
template <Ring R, std::size_t N>
Result<BSpline<R, N>> restricted(const BSpline<R, N>& map,
                                 const std::array<typename RingNumbers<R>::Knot, N>& a,
                                 const std::array<typename RingNumbers<R>::Knot, N>& b) {
  Result<BSpline<R, N>> part = map;
  for (std::size_t axis = 0; part && axis < N; ++axis)
    part = restricted(part.value(), axis, a[axis], b[axis]);
  return part;
}
/// Clamps the map at both ends of an axis; knots outside of the domain are dropped.
template <Ring R, std::size_t N>
BSpline<R, N> clamped(const BSpline<R, N>& map, std::size_t axis) {
  return internal::clamped_part(map, axis, map.axis(axis).domain_begin(),
                                map.axis(axis).domain_end());
}

/// u -> F(-u) on the domain [-end, -begin]: no ring rounds it.
template <Ring R, std::size_t N>
BSpline<R, N> mirrored(const BSpline<R, N>& map, std::size_t axis) {
  std::vector<typename RingNumbers<R>::Knot> knots;
  for (const auto& u : map.axis(axis).knots) knots.push_back(-u);
  std::reverse(knots.begin(), knots.end());
  return internal::with_knots(map, axis, std::move(knots), true);
}

/// u -> F(begin + end - u), on the same domain. It needs exact knots; where knots are rounded (double), use mirrored.
template <Ring R, std::size_t N>
requires std::same_as<typename RingNumbers<R>::Knot, Rational> BSpline<R, N> reversed(
    const BSpline<R, N>& map, std::size_t axis) {
  const Rational sum = map.axis(axis).domain_begin() + map.axis(axis).domain_end();
  std::vector<Rational> knots;
  for (const Rational& u : map.axis(axis).knots) knots.push_back(sum - u);
  std::reverse(knots.begin(), knots.end());
  return internal::with_knots(map, axis, std::move(knots), true);
}

/// u -> F(the point of the domain in the place that u has in [begin, end]): all knots moved by one affine map.
/// @error kBadArgument unless begin < end; kLossy, with a knot, where rounded knots (double) would not stay apart or
/// finite.
template <Ring R, std::size_t N>
Result<BSpline<R, N>> with_domain(const BSpline<R, N>& map, std::size_t axis,
                                  const typename RingNumbers<R>::Knot& begin,
                                  const typename RingNumbers<R>::Knot& end) {
  using Knot = typename RingNumbers<R>::Knot;
  if (!(begin < end)) return internal::empty_domain(axis, begin, end);
  const auto& old_axis = map.axis(axis);
  const Knot &a = old_axis.domain_begin(), &b = old_axis.domain_end();
  const Knot length = end - begin, old_length = b - a;
  std::vector<Knot> knots;
  for (const Knot& u : old_axis.knots) {
    Knot moved = u == b ? end : begin + (u - a) * length / old_length;
    if (!(moved - moved == Knot(0))) return internal::knots_collide(axis, knots.size(), u, moved);
    if (!knots.empty()) {
      const Knot& last = old_axis.knots[knots.size() - 1];
      if (last < u ? !(knots.back() < moved) : !(knots.back() == moved))
        return internal::knots_collide(axis, knots.size(), u, moved);
    }
    knots.push_back(std::move(moved));
  }
  return internal::with_knots(map, axis, std::move(knots), false);
}

/// The map with its variables in another order: new axis i is old axis order[i]. REQUIRES a permutation.
template <Ring R, std::size_t N>
BSpline<R, N> permuted(const BSpline<R, N>& map, const std::array<std::size_t, N>& order) {
  return BSpline<R, N>(internal::permuted(map.axes(), order), map.num_components(),
                       map.is_rational(),
                       internal::permuted_net(map.coefficients(), map.grid(), order));
}
/// Two axes exchanged.
template <Ring R, std::size_t N>
BSpline<R, N> swapped(const BSpline<R, N>& map, std::size_t axis, std::size_t other) {
  std::array<std::size_t, N> order;
  for (std::size_t i = 0; i < N; ++i) order[i] = i;
  std::swap(order[axis], order[other]);
  return permuted(map, order);
}

}  // namespace veritope
