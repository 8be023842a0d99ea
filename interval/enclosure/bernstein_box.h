// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/bernstein_box.h: Bezier maps with interval coefficients on boxes of parameters: restriction, hull,
// derivative.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "splines/de_casteljau.h"
#include "splines/restriction.h"

namespace veritope {

/// The map on the part `local` of [0,1]^N, as a map of [0,1]^N: coefficients that contain those of every map that
/// `piece` stands for. The ends of `local` are taken as exact numbers.
/// REQUIRES local inside [0,1]^N and a live ScopedUpward.  @cost 2 (degree + 1)^2 / 2 blends for each line and axis
template <std::size_t N>
Bezier<Interval, N> on_box(Bezier<Interval, N> piece, const Box<N>& local) {
  const Interval one(1.0);
  for (std::size_t a = 0; a < N; ++a) {
    const double lo = local[a].lo(), hi = local[a].hi();
    const internal::OrderOfCuts order = internal::order_of_cuts(lo, hi);
    if (!order.cuts_begin && !order.cuts_end) continue;
    const internal::CutPlaces<Interval> places(Interval(lo), Interval(hi), one, order.end_first);
    const internal::PartCuts<internal::AffineBlend<Interval>> cuts{
        order, internal::cut_at(places.begin), internal::cut_at(places.end)};
    internal::on_lines(piece, a, [&](Interval* first, std::size_t stride) {
      cuts.apply(first, stride, piece.degree(a));
    });
  }
  return piece;
}

/// The hull of all coefficients of a component, which contains its values on [0,1]^N. For a piece that on_box has cut,
/// the excess over its exact range is O(width^2) if the coefficients are points.
template <std::size_t N>
Interval hull_of(const Bezier<Interval, N>& piece, int component) {
  Interval out = Interval::empty();
  for (const Interval& v : piece.component(component)) out = hull(out, v);
  return out;
}

/// The derivative along an axis of a cell of length h, in the ring of the coefficients: exact over Rational.
template <Ring R, std::size_t N>
Bezier<R, N> cell_derivative(const Bezier<R, N>& map, std::size_t axis, const Rational& h) {
  auto degrees = map.degrees();
  const int n = degrees[axis];
  if (n == 0) return Bezier<R, N>(degrees, map.num_components(), map.is_rational());
  --degrees[axis];
  Bezier<R, N> out(degrees, map.num_components(), map.is_rational());
  const R factor = RingNumbers<R>::of_knot(Rational(n) / h);
  const Grid<N> from = map.grid(), to = out.grid();
  const std::size_t stride =
      from.stride(axis);  // `to` has the same stride: the axes after this one are unchanged
  std::vector<std::size_t> first;
  from.for_each_line(axis, [&](std::size_t i) { first.push_back(i); });
  for (int c = 0; c < map.num_components(); ++c) {
    std::size_t line = 0;
    to.for_each_line(axis, [&](std::size_t i) {
      const R* const x = map.component(c).data() + first[line++];
      for (std::size_t k = 0; k < to.size[axis]; ++k)
        out.component(c)[i + k * stride] = factor * (x[(k + 1) * stride] - x[k * stride]);
    });
  }
  return out;
}

}  // namespace veritope
