// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/knot_insertion.h: more knots, the same map (Boehm 1980), and the Bezier pieces of a B-spline.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "splines/bezier.h"
#include "splines/bspline.h"

namespace veritope {
namespace internal {

/// The span k with knots[k] <= u < knots[k + 1]; for u = domain_end() the last one that is not empty.
/// REQUIRES u in the domain.
template <typename Knot>
std::size_t find_span(const KnotAxis<Knot>& axis, const Knot& u) {
  const auto begin = axis.knots.begin();
  const auto first = begin + axis.degree,
             last = begin + static_cast<std::ptrdiff_t>(axis.num_control());
  auto above = std::upper_bound(first, last, u);  // in (domain_begin, domain_end)
  if (above == last && !(u < *last)) above = std::lower_bound(first, last, *last);
  return static_cast<std::size_t>(above - begin) - 1;
}

}  // namespace internal

/// How often u is a knot.
template <typename Knot>
int multiplicity(const KnotAxis<Knot>& axis, const Knot& u) {
  const auto [first, last] = std::equal_range(axis.knots.begin(), axis.knots.end(), u);
  return static_cast<int>(last - first);
}

/// The same map with u once more among the knots of an axis. A periodic axis becomes an unclamped one.
/// REQUIRES u in the domain, its multiplicity <= degree.
template <Ring R, std::size_t N>
BSpline<R, N> insert_knot(const BSpline<R, N>& map, std::size_t axis,
                          const typename RingNumbers<R>::Knot& u) {
  const auto& old_axis = map.axis(axis);
  const auto p = static_cast<std::size_t>(old_axis.degree);
  const std::size_t k = internal::find_span(old_axis, u);
  auto axes = map.axes();
  axes[axis].is_periodic = false;
  axes[axis].knots.insert(axes[axis].knots.begin() + static_cast<std::ptrdiff_t>(k) + 1, u);
  std::vector<R> alpha(p + 1), beta(p + 1);  // of i = k - p + 1 + j
  const R t = RingNumbers<R>::of_knot(u);
  for (std::size_t j = 0; j < p; ++j) {
    const std::size_t i = k - p + 1 + j;
    alpha[j] = RingNumbers<R>::fraction(t, old_axis.knots[i], old_axis.knots[i + p]);
    beta[j] = one<R>() - alpha[j];
  }
  const Grid<N> old_grid = map.grid();
  Grid<N> grid = old_grid;
  ++grid.size[axis];
  std::vector<R> coefficients(grid.count() * static_cast<std::size_t>(map.num_components()));
  const std::size_t stride = grid.stride(axis), n = old_grid.size[axis];
  for (int c = 0; c < map.num_components(); ++c) {
    const R* const from = map.component(c).data();
    R* const to = coefficients.data() + static_cast<std::size_t>(c) * grid.count();
    std::vector<std::size_t> first_of_line;
    grid.for_each_line(axis, [&](std::size_t first) { first_of_line.push_back(first); });
    std::size_t line = 0;
    old_grid.for_each_line(axis, [&](std::size_t first) {
      const R* const q = from + first;
      R* const r = to + first_of_line[line++];
      for (std::size_t i = 0; i <= n; ++i) {
        if (i + p <= k) {
          r[i * stride] = q[i * stride];
        } else if (i > k) {
          r[i * stride] = q[(i - 1) * stride];
        } else {
          const std::size_t j = i + p - k - 1;
          r[i * stride] = blend(q[(i - 1) * stride], q[i * stride], beta[j], alpha[j]);
        }
      }
    });
  }
  return BSpline<R, N>(std::move(axes), map.num_components(), map.is_rational(),
                       std::move(coefficients));
}

/// A B-spline cut at its knots: breaks[a][i] < breaks[a][i + 1] are the different knots of axis a in the domain, and
/// the piece with index (i, j, ...) is the map of the cell [breaks[0][i], breaks[0][i + 1]] x ..., as a map of [0,1]^N.
template <Ring R, std::size_t N>
struct BezierPieces {
  std::array<std::vector<typename RingNumbers<R>::Knot>, N> breaks;
  std::vector<Bezier<R, N>> pieces;  // as grid() says, the last axis fastest

  Grid<N> grid() const {
    Grid<N> g;
    for (std::size_t i = 0; i < N; ++i) g.size[i] = breaks[i].size() - 1;
    return g;
  }
  const Bezier<R, N>& at(const std::array<std::size_t, N>& index) const {
    return pieces[grid().at(index)];
  }
};

template <Ring R, std::size_t N>
BezierPieces<R, N> bezier_pieces(BSpline<R, N> map) {
  BezierPieces<R, N> out;
  std::array<int, N> degrees;
  std::array<std::vector<std::size_t>, N> spans;  // the last index of each break among the knots
  for (std::size_t a = 0; a < N; ++a) {
    degrees[a] = map.axis(a).degree;
    const auto axis = map.axis(a);
    for (std::size_t i = static_cast<std::size_t>(axis.degree); i <= axis.num_control(); ++i)
      if (out.breaks[a].empty() || out.breaks[a].back() < axis.knots[i])
        out.breaks[a].push_back(axis.knots[i]);
    for (const auto& u : out.breaks[a])
      for (int m = multiplicity(map.axis(a), u); m < axis.degree; ++m) map = insert_knot(map, a, u);
    for (std::size_t i = 0; i + 1 < out.breaks[a].size(); ++i)
      spans[a].push_back(internal::find_span(map.axis(a), out.breaks[a][i]));
  }
  const Grid<N> cells = out.grid(), net = map.grid();
  std::array<std::size_t, N> cell{};
  for (std::size_t number = 0; number < cells.count(); ++number) {
    std::size_t rest = number;
    for (std::size_t a = N; a-- > 0; rest /= cells.size[a]) cell[a] = rest % cells.size[a];
    Bezier<R, N> piece(degrees, map.num_components(), map.is_rational());
    const Grid<N> grid = piece.grid();
    for (int c = 0; c < map.num_components(); ++c)
      for (std::size_t i = 0; i < grid.count(); ++i) {
        std::array<std::size_t, N> index;
        std::size_t left = i;
        for (std::size_t a = N; a-- > 0; left /= grid.size[a])
          index[a] = spans[a][cell[a]] - static_cast<std::size_t>(degrees[a]) + left % grid.size[a];
        piece.component(c)[i] = map.component(c)[net.at(index)];
      }
    out.pieces.push_back(std::move(piece));
  }
  return out;
}

}  // namespace veritope
