// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline_derivative.h: derivatives of B-splines and NURBS.
#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/bezier_calculus.h"
#include "splines/bspline.h"
#include "splines/bspline_pieces.h"
#include "splines/knot_insertion.h"
#include "splines/lines.h"
#include "splines/periodic.h"

namespace veritope {
namespace internal {

/// Control points i = factors[i] (from[index[i]] - from[index[i] - 1]), with a degree one lower. Over an empty span,
/// between the two values of a jump, there is no difference: its knot loses one copy.
template <typename Knot>
struct DerivativeAxis {
  KnotAxis<Knot> axis;
  std::vector<std::size_t> index;
  std::vector<Knot> factors;

  explicit DerivativeAxis(const KnotAxis<Knot>& from)
      : axis{from.degree - 1, {}, from.is_periodic} {
    const std::size_t p = static_cast<std::size_t>(from.degree), n = from.num_control();
    const std::vector<Knot>& t = from.knots;
    for (std::size_t i = 1; i + 1 < t.size(); ++i) {
      if (i < n && !(t[i] < t[i + p])) continue;
      axis.knots.push_back(t[i]);
      if (i >= n) continue;
      index.push_back(i);
      factors.push_back(Knot(from.degree) / (t[i + p] - t[i]));
    }
  }

  /// Cuts the extended derivative along a periodic axis down to the stored part.
  void cut_like(const KnotAxis<Knot>& periodic) {
    const PeriodCut cut(axis.knots, static_cast<std::size_t>(axis.degree), periodic);
    axis.knots.assign(axis.knots.begin() + static_cast<std::ptrdiff_t>(cut.first),
                      axis.knots.begin() + static_cast<std::ptrdiff_t>(cut.past));
    index.erase(index.begin(), index.begin() + static_cast<std::ptrdiff_t>(cut.first));
    factors.erase(factors.begin(), factors.begin() + static_cast<std::ptrdiff_t>(cut.first));
    axis.is_periodic = true;
  }
};

template <Ring R, std::size_t N>
BSpline<R, N> component_derivative(const BSpline<R, N>& map, std::size_t axis) {
  const auto& old_axis = map.axis(axis);
  VT_CHECK(old_axis.degree > 0, "derivative of a piecewise constant map");
  const bool is_periodic = old_axis.is_periodic;
  DerivativeAxis lower(is_periodic ? extended_axis(old_axis) : old_axis);
  if (is_periodic) lower.cut_like(old_axis);
  const std::vector<R> factors = numbers_of_knots<R>(lower.factors);
  const std::size_t old_n = old_axis.num_control(), n = lower.axis.num_control();
  const auto p = static_cast<std::size_t>(old_axis.degree);
  auto axes = map.axes();
  axes[axis] = std::move(lower.axis);
  std::vector<R> extended;
  return {std::move(axes), map.num_components(), map.is_rational(),
          map_lines(map, axis, n, [&](Line<const R> from, Line<R> to) {
            if (is_periodic) {
              extend_line(from, old_n, p, extended);
              from = {extended.data(), 1};
            }
            for (std::size_t i = 0; i < n; ++i)
              to[i] = factors[i] * (from[lower.index[i]] - from[lower.index[i] - 1]);
            if (is_periodic) close_period(to, n, p - 1);
          })};
}

/// The multiplicities at which a product of degree 2p, or with `by` = 1 of a map and its derivative, is as smooth as it
/// must be.
template <typename Knot>
std::vector<int> product_multiplicities(const KnotAxis<Knot>& axis, const std::vector<Knot>& breaks,
                                        int by) {
  std::vector<int> out;
  for (const Knot& u : breaks)
    out.push_back(std::min(axis.degree + multiplicity(axis, u) + by, 2 * axis.degree + 1));
  return out;
}

/// (w P' - w' P) / w^2, piece by piece.
template <Ring R, std::size_t N>
BSpline<R, N> quotient_derivative(const BSpline<R, N>& map, std::size_t axis) {
  BezierPieces<R, N> pieces = bezier_pieces(map);
  const Grid<N> cells = pieces.grid();
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    const std::size_t cell = cells.index_of(i)[axis];
    const auto& breaks = pieces.breaks[axis];
    const R per_length = RingNumbers<R>::of_knot(typename RingNumbers<R>::Knot(1) /
                                                 (breaks[cell + 1] - breaks[cell]));
    Bezier<R, N> piece = derivative(pieces.pieces[i], axis);
    for (int c = 0; c < piece.dimension(); ++c)
      for (R& v : piece.component(c)) v = per_length * v;
    pieces.pieces[i] = std::move(piece);
  }
  BSpline<R, N> out = joined(pieces);
  for (std::size_t a = 0; a < N; ++a) {
    const auto times = product_multiplicities(map.axis(a), pieces.breaks[a], a == axis ? 1 : 0);
    out = with_fewer_knots(out, a, clamped_axis(out.axis(a).degree, pieces.breaks[a], times));
  }
  return out;
}

}  // namespace internal

/// The derivative along `axis`; at a knot inside the domain where it jumps, the derivative from the right. For a
/// polynomial map its degree along the axis is one lower; it has the same knots but the first and the last, and is
/// periodic if the map is. From degree 1 it is a piecewise constant map of degree 0, which has no derivative itself.
/// For a rational map it is (w P' - w' P) / w^2: rational, clamped, with twice the degrees along all axes, with the
/// weight w^2, and with each knot as often as its smoothness needs.
template <Ring R, std::size_t N>
BSpline<R, N> derivative(const BSpline<R, N>& map, std::size_t axis) {
  return map.is_rational() ? internal::quotient_derivative(map, axis)
                           : internal::component_derivative(map, axis);
}

}  // namespace veritope
