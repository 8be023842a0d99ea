// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/composition_span.h: composition with one polynomial piece of a B-spline.
#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "splines/composition.h"
#include "splines/knot_insertion.h"

namespace veritope {

/// Rings whose numbers are exact and can therefore be compared with knots.
template <typename R>
concept ComparableRing = Ring<R> &&(std::same_as<R, double> || std::same_as<R, Rational>);

namespace internal {
inline Rational exactly(double v) { return Rational::from_double(v); }
inline const Rational& exactly(const Rational& v) { return v; }

/// The least and the greatest value of a coordinate over the control points, exactly, with the weight divided out.
/// @error kBadArgument for a weight that is not positive.
template <ComparableRing R, std::size_t N>
Result<std::pair<Rational, Rational>> hull_of(const Bezier<R, N>& map, int coordinate) {
  std::pair<Rational, Rational> hull;
  for (std::size_t i = 0; i < map.grid().count(); ++i) {
    Rational v = exactly(map.component(coordinate)[i]);
    if (map.is_rational()) {
      const Rational w = exactly(map.component(map.dimension())[i]);
      if (w.sign() != Sign::kPositive)
        return Error{Code::kBadArgument,
                     {},
                     "control point " + std::to_string(i) + " of the inner map has the weight " +
                         w.to_string()};
      v /= w;
    }
    if (i == 0) hull = {v, v};
    hull = {std::min(hull.first, v), std::max(hull.second, v)};
  }
  return hull;
}

/// The span of the axis whose closed interval contains the hull; if there are two, the left one.
template <typename Knot>
Result<std::size_t> span_of_hull(const KnotAxis<Knot>& axis,
                                 const std::pair<Rational, Rational>& hull, std::size_t number) {
  for (std::size_t k = static_cast<std::size_t>(axis.degree); k < axis.num_control(); ++k)
    if (axis.knots[k] < axis.knots[k + 1] && exactly(axis.knots[k]) <= hull.first &&
        hull.second <= exactly(axis.knots[k + 1]))
      return k;
  return Error{Code::kBadArgument,
               {},
               "coordinate " + std::to_string(number) +
                   " of the inner map's control points, from " + hull.first.to_string() + " to " +
                   hull.second.to_string() + ", is in no knot span of the outer map"};
}

}  // namespace internal

/// For every axis, the number k of the knot span [knots[k], knots[k + 1]], not empty and in the domain, that contains
/// all control points of the inner map. The hull decides, in exact numbers: a map that stays in a span while a control
/// point does not is refused, too. Callers may split such a map.
/// @error kBadArgument with the coordinate and its range, or with a weight that is not positive; inner.dimension() !=
/// M.
template <ComparableRing R, std::size_t M, std::size_t N>
Result<std::array<std::size_t, M>> containing_span(const BSpline<R, M>& outer,
                                                   const Bezier<R, N>& inner) {
  if (inner.dimension() != static_cast<int>(M))
    return Error{Code::kBadArgument,
                 {},
                 "the points of the inner map have " + std::to_string(inner.dimension()) +
                     " coordinates, the outer map has " + std::to_string(M) + " variables"};
  std::array<std::size_t, M> spans{};
  for (std::size_t m = 0; m < M; ++m) {
    const auto hull = internal::hull_of(inner, static_cast<int>(m));
    if (!hull) return hull.error();
    const auto span = internal::span_of_hull(outer.axis(m), *hull, m);
    if (!span) return span.error();
    spans[m] = *span;
  }
  return spans;
}

/// The piece of a B-spline on one product of knot spans, as a map of [0,1]^M: only the coefficients and knots that it
/// needs are examined. REQUIRES, for every axis, a span in the domain that is not empty.
template <Ring R, std::size_t M>
Bezier<R, M> bezier_piece(const BSpline<R, M>& map, const std::array<std::size_t, M>& spans) {
  std::array<typename BSpline<R, M>::Axis, M> axes;
  Grid<M> local;
  for (std::size_t m = 0; m < M; ++m) {
    const auto p = static_cast<std::size_t>(map.axis(m).degree);
    const auto first = map.axis(m).knots.begin() + static_cast<std::ptrdiff_t>(spans[m] - p);
    axes[m] = {map.axis(m).degree, {first, first + static_cast<std::ptrdiff_t>(2 * p + 2)}, false};
    local.size[m] = p + 1;
  }
  std::vector<R> coefficients;
  for (int c = 0; c < map.num_components(); ++c)
    internal::for_each_index(local, [&](std::array<std::size_t, M> index, std::size_t) {
      for (std::size_t m = 0; m < M; ++m) index[m] += spans[m] + 1 - local.size[m];
      coefficients.push_back(map.component(c)[map.grid().at(index)]);
    });
  const BSpline<R, M> part(axes, map.num_components(), map.is_rational(), std::move(coefficients));
  return bezier_pieces(part).pieces.front();
}

/// outer(inner(x)) for an inner map that stays in one knot span of the outer one, as containing_span says. Exact for
/// Rational; for double rounded, without a bound.
/// @error as containing_span and compose.
template <ComparableRing R, std::size_t M, std::size_t N>
Result<Bezier<R, N>> compose_on_span(const BSpline<R, M>& outer, const Bezier<R, N>& inner) {
  const auto spans = containing_span(outer, inner);
  if (!spans) return spans.error();
  using Numbers = RingNumbers<R>;
  Bezier<R, N> local = inner;  // in the variables of the piece
  for (std::size_t m = 0; m < M; ++m) {
    const auto& begin = outer.axis(m).knots[(*spans)[m]];
    const auto& end = outer.axis(m).knots[(*spans)[m] + 1];
    const R a = Numbers::of_knot(begin), width = Numbers::of_knot(end - begin);
    for (std::size_t i = 0; i < inner.grid().count(); ++i) {
      R& x = local.component(static_cast<int>(m))[i];
      if (inner.is_rational()) {
        x = internal::divided<R>(x - a * inner.component(static_cast<int>(M))[i], width);
      } else {
        x = Numbers::fraction(x, begin, end);
      }
    }
  }
  return compose(bezier_piece(outer, *spans), local);
}

}  // namespace veritope
