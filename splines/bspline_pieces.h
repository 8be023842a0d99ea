// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline_pieces.h: from Bezier maps back to B-splines; knots that a map does not need.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/result.h"
#include "splines/bezier.h"
#include "splines/blossom_weights.h"
#include "splines/bspline.h"
#include "splines/bspline_domain.h"
#include "splines/knot_insertion.h"
#include "splines/lines.h"

namespace veritope {

/// Converts the map to a B-spline without inner knots, moved from [0,1]^N to the box from `begin` to `end`.
/// REQUIRES begin < end in every axis.
template <Ring R, std::size_t N>
BSpline<R, N> to_bspline(const Bezier<R, N>& map,
                         const std::array<typename RingNumbers<R>::Knot, N>& begin,
                         const std::array<typename RingNumbers<R>::Knot, N>& end) {
  std::array<typename BSpline<R, N>::Axis, N> axes;
  for (std::size_t a = 0; a < N; ++a) {
    VT_CHECK(begin[a] < end[a], "a domain needs a begin below its end");
    const auto order = static_cast<std::size_t>(map.degree(a)) + 1;
    axes[a].degree = map.degree(a);
    axes[a].knots.assign(order, begin[a]);
    axes[a].knots.insert(axes[a].knots.end(), order, end[a]);
  }
  return {std::move(axes), map.num_components(), map.is_rational(),
          std::vector<R>(map.coefficients().begin(), map.coefficients().end())};
}
/// Converts the map to a B-spline on [0,1]^N without inner knots.
template <Ring R, std::size_t N>
BSpline<R, N> to_bspline(const Bezier<R, N>& map) {
  std::array<typename RingNumbers<R>::Knot, N> begin, end;
  begin.fill(typename RingNumbers<R>::Knot(0));
  end.fill(typename RingNumbers<R>::Knot(1));
  return to_bspline(map, begin, end);
}

/// The pieces as one clamped map, of any continuity, since every inner knot occurs degree + 1 times. It undoes
/// bezier_pieces, except for these knots. REQUIRES pieces of the same degrees, number of components and kind.
template <Ring R, std::size_t N>
BSpline<R, N> joined(const BezierPieces<R, N>& in) {
  const Bezier<R, N>& any = in.pieces.front();
  const Grid<N> cells = in.grid(), local = any.grid();
  std::array<typename BSpline<R, N>::Axis, N> axes;
  Grid<N> net;
  for (std::size_t a = 0; a < N; ++a) {
    axes[a].degree = any.degree(a);
    for (const auto& u : in.breaks[a]) axes[a].knots.insert(axes[a].knots.end(), local.size[a], u);
    net.size[a] = axes[a].num_control();
  }
  std::vector<R> out(net.count() * static_cast<std::size_t>(any.num_components()));
  for (std::size_t number = 0; number < cells.count(); ++number) {
    const Bezier<R, N>& piece = in.pieces[number];
    VT_CHECK(piece.degrees() == any.degrees() && piece.num_components() == any.num_components() &&
                 piece.is_rational() == any.is_rational(),
             "pieces of one map are of one kind");
    const auto cell = cells.index_of(number);
    for (std::size_t i = 0; i < local.count(); ++i) {
      auto index = local.index_of(i);
      for (std::size_t a = 0; a < N; ++a) index[a] += cell[a] * local.size[a];
      for (int c = 0; c < any.num_components(); ++c)
        out[static_cast<std::size_t>(c) * net.count() + net.at(index)] = piece.component(c)[i];
    }
  }
  return {std::move(axes), any.num_components(), any.is_rational(), std::move(out)};
}

namespace internal {

/// The map on an axis with fewer knots, by blossoms at its knots; each blossom is that of the middle one of the spans
/// where the control point counts. Equal to `map` iff the map has such a form. REQUIRES a clamped axis of the same
/// degree and domain, its knots among those of the map.
/// @cost degree^2 / 2 quotients per control point, and degree products for each line
template <Ring R, std::size_t N>
BSpline<R, N> with_fewer_knots(const BSpline<R, N>& map, std::size_t axis,
                               KnotAxis<typename RingNumbers<R>::Knot> coarse) {
  using Knot = typename RingNumbers<R>::Knot;
  const auto& fine = map.axis(axis);
  const auto p = static_cast<std::size_t>(coarse.degree);
  const std::size_t n = coarse.num_control();
  std::vector<std::size_t> first;
  std::vector<std::vector<R>> weights;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::size_t> spans;
    for (std::size_t s = std::max(i, p); s <= std::min(i + p, n - 1); ++s)
      if (coarse.knots[s] < coarse.knots[s + 1]) spans.push_back(s);
    VT_CHECK(!spans.empty(), "a control point without influence on the domain");
    const std::size_t span = find_span(fine, coarse.knots[spans[spans.size() / 2]]);
    first.push_back(span - p);
    weights.push_back(numbers_of_knots<R>(
        blossom_weights<Knot>(fine, span, std::span<const Knot>(coarse.knots).subspan(i + 1, p))));
  }
  auto axes = map.axes();
  axes[axis] = std::move(coarse);
  return {std::move(axes), map.num_components(), map.is_rational(),
          map_lines(map, axis, n, [&](auto from, auto to) {
            for (std::size_t i = 0; i < n; ++i)
              for (std::size_t j = 0; j <= p; ++j)
                accumulate(to[i], weights[i][j] * from[first[i] + j]);
          })};
}

/// A clamped axis with the given breaks, inner ones of these multiplicities.
template <typename Knot>
KnotAxis<Knot> clamped_axis(int degree, const std::vector<Knot>& breaks,
                            const std::vector<int>& multiplicities) {
  KnotAxis<Knot> axis{degree, {}, false};
  const auto ends = static_cast<std::size_t>(degree) + 1;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == breaks.size();
    axis.knots.insert(axis.knots.end(), is_end ? ends : static_cast<std::size_t>(multiplicities[i]),
                      breaks[i]);
  }
  return axis;
}

}  // namespace internal

/// Removes some knots; the map stays the same.
/// @error kBadArgument for a knot that the axis does not have, or that is not strictly inside of the domain; kLossy if
///        no map with the other knots is the same.
template <std::size_t N>
Result<BSpline<Rational, N>> without_knots(const BSpline<Rational, N>& map, std::size_t axis,
                                           const std::vector<Rational>& knots) {
  const BSpline<Rational, N> old = clamped(map, axis);
  auto coarse = old.axis(axis);
  for (const Rational& u : knots) {
    const auto at = std::lower_bound(coarse.knots.begin(), coarse.knots.end(), u);
    if (at == coarse.knots.end() || *at != u || u == coarse.domain_begin() ||
        u == coarse.domain_end())
      return internal::axis_error(
          Code::kBadArgument, axis,
          internal::knot_text(u) + " is not a knot inside of the domain, or not as often");
    coarse.knots.erase(at);
  }
  auto sorted = knots;
  std::sort(sorted.begin(), sorted.end());
  BSpline<Rational, N> candidate = internal::with_fewer_knots(old, axis, std::move(coarse));
  if (refine(candidate, axis, sorted) == old) return candidate;
  return internal::axis_error(Code::kLossy, axis,
                              "without " + std::to_string(knots.size()) +
                                  " knots, the first of them " +
                                  internal::knot_text(sorted.front()) + ", the map would change");
}

// Compiled once, in rational_instances.cc.
extern template BSpline<Rational, 1> joined(const BezierPieces<Rational, 1>&);
extern template BSpline<Rational, 2> joined(const BezierPieces<Rational, 2>&);
extern template BSpline<Rational, 3> joined(const BezierPieces<Rational, 3>&);

}  // namespace veritope
