// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/knot_insertion.h: inserts knots without changing the map, up to the Bezier pieces of a B-spline.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/bezier.h"
#include "splines/blossom_weights.h"
#include "splines/bspline.h"
#include "splines/lines.h"

namespace veritope {

/// How often u is a knot.
template <typename Knot>
int multiplicity(const KnotAxis<Knot>& axis, const Knot& u) {
  const auto [first, last] = std::equal_range(axis.knots.begin(), axis.knots.end(), u);
  return static_cast<int>(last - first);
}

namespace internal {

/// Many insertions into one axis, prepared to be applied to line after line of control points.
/// Source: [PT97] A5.4, which goes through the knots once, from the last to the first.
template <Ring R>
class Refinement {
 public:
  using Knot = typename RingNumbers<R>::Knot;

  /// REQUIRES what refine says; at least one knot. @cost degree quotients per inserted knot
  Refinement(const KnotAxis<Knot>& old_axis, const std::vector<Knot>& inserted)
      : p_(static_cast<std::size_t>(old_axis.degree)),
        n_(old_axis.num_control()),
        num_inserted_(inserted.size()),
        first_span_(find_span(old_axis, inserted.front())),
        past_last_span_(find_span(old_axis, inserted.back()) + 1) {
    axis_.degree = old_axis.degree;
    std::merge(old_axis.knots.begin(), old_axis.knots.end(), inserted.begin(), inserted.end(),
               std::back_inserter(axis_.knots));
    std::size_t i = past_last_span_ + p_ - 1;
    std::size_t k = i + num_inserted_;  // knot k of the new axis is the next to be made
    for (std::size_t j = num_inserted_; j-- > 0; --k) {
      const Knot& u = inserted[j];
      moves_.push_back(0);
      for (; i > first_span_ && u <= old_axis.knots[i]; --i, --k) ++moves_.back();
      for (std::size_t l = 1; l <= p_; ++l)
        blends_.push_back(blend_at(u, old_axis.knots[i - p_ + l], axis_.knots[k + l]));
    }
  }

  /// The new axis, which is not periodic.
  const KnotAxis<Knot>& axis() const { return axis_; }

  /// Computes the points of a line of the new axis from the num_control() points of the old one. @cost degree blends
  /// per inserted knot
  void apply(Line<const R> from, Line<R> to) const {
    for (std::size_t j = 0; j + p_ <= first_span_; ++j) to[j] = from[j];
    for (std::size_t j = past_last_span_ - 1; j < n_; ++j) to[j + num_inserted_] = from[j];
    std::size_t i = past_last_span_ + p_ - 1, k = i + num_inserted_;
    auto next = blends_.begin();
    for (const std::size_t moves : moves_) {
      for (std::size_t m = 0; m < moves; ++m, --i, --k) to[k - p_ - 1] = from[i - p_ - 1];
      to[k - p_ - 1] = to[k - p_];
      for (std::size_t at = k - p_; at < k; ++at, ++next) {
        if (next->kind == Kind::kTakeSecond) to[at] = to[at + 1];
        if (next->kind == Kind::kBlend) to[at] = next->first * to[at] + next->second * to[at + 1];
      }
      --k;
    }
  }

 private:
  enum class Kind { kTakeFirst, kTakeSecond, kBlend };
  struct Blend {
    Kind kind;
    R first, second;  // factors of the two points
  };
  // Nothing is multiplied by 0 or 1: this is exact in rings that round, and cheaper.
  static Blend blend_at(const Knot& u, const Knot& low, const Knot& high) {
    if (!(u < high)) return {Kind::kTakeSecond, R(), R()};
    if (!(low < u)) return {Kind::kTakeFirst, R(), R()};
    return {Kind::kBlend, RingNumbers<R>::of_knot((high - u) / (high - low)),
            RingNumbers<R>::of_knot((u - low) / (high - low))};
  }

  std::size_t p_, n_, num_inserted_;
  std::size_t first_span_, past_last_span_;
  KnotAxis<Knot> axis_;
  std::vector<std::size_t>
      moves_;  // for each inserted knot, the last one first: old points right of it to be moved
  std::vector<Blend> blends_;  // `degree` for each
};

}  // namespace internal

/// Inserts knots on an axis; the map stays the same. A periodic axis becomes an unclamped one. Each new control point
/// is a convex combination of old ones. REQUIRES knots in the domain, not decreasing, of which none then occurs more
/// than degree + 1 times.
/// @cost degree blends per inserted knot, and one copy per control point, for each line
template <Ring R, std::size_t N>
BSpline<R, N> refine(const BSpline<R, N>& map, std::size_t axis,
                     const std::vector<typename RingNumbers<R>::Knot>& knots) {
  auto axes = map.axes();
  if (knots.empty()) return map;
  VT_CHECK(std::is_sorted(knots.begin(), knots.end()) && axes[axis].domain_begin() <= knots[0] &&
               knots.back() <= axes[axis].domain_end(),
           "knots to be inserted are sorted and lie in the domain");
  const internal::Refinement<R> refinement(axes[axis], knots);
  axes[axis] = refinement.axis();
  const auto order = static_cast<std::size_t>(axes[axis].degree) + 1;
  for (std::size_t i = order; i < axes[axis].knots.size(); ++i)
    VT_CHECK(axes[axis].knots[i - order] < axes[axis].knots[i],
             "a knot occurs at most degree + 1 times");
  return BSpline<R, N>(
      std::move(axes), map.num_components(), map.is_rational(),
      internal::map_lines(map, axis, refinement.axis().num_control(),
                          [&](auto from, auto to) { refinement.apply(from, to); }));
}

/// Inserts u once more into the knots of an axis. REQUIRES u in the domain, its multiplicity <= degree.
template <Ring R, std::size_t N>
BSpline<R, N> insert_knot(const BSpline<R, N>& map, std::size_t axis,
                          const typename RingNumbers<R>::Knot& u) {
  return refine(map, axis, {u});
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

namespace internal {

/// The different knots in the domain.
template <typename Knot>
std::vector<Knot> breaks_of(const KnotAxis<Knot>& axis) {
  std::vector<Knot> breaks;
  for (std::size_t i = static_cast<std::size_t>(axis.degree); i <= axis.num_control(); ++i)
    if (breaks.empty() || breaks.back() < axis.knots[i]) breaks.push_back(axis.knots[i]);
  return breaks;
}

/// The copies that each of the given knots lacks to occur `degree` times.
template <typename Knot>
std::vector<Knot> missing_knots(const KnotAxis<Knot>& axis, const std::vector<Knot>& breaks) {
  std::vector<Knot> missing;
  for (const Knot& u : breaks)
    for (int m = multiplicity(axis, u); m < axis.degree; ++m) missing.push_back(u);
  return missing;
}

}  // namespace internal

/// @cost that of refine, and one copy of each coefficient
template <Ring R, std::size_t N>
BezierPieces<R, N> bezier_pieces(BSpline<R, N> map) {
  BezierPieces<R, N> out;
  std::array<int, N> degrees;
  std::array<std::vector<std::size_t>, N> first;  // control point of each cell
  for (std::size_t a = 0; a < N; ++a) {
    degrees[a] = map.axis(a).degree;
    out.breaks[a] = internal::breaks_of(map.axis(a));
    map = refine(map, a, internal::missing_knots(map.axis(a), out.breaks[a]));
    for (std::size_t i = 0; i + 1 < out.breaks[a].size(); ++i)
      first[a].push_back(internal::find_span(map.axis(a), out.breaks[a][i]) -
                         static_cast<std::size_t>(degrees[a]));
  }
  const Grid<N> cells = out.grid(), net = map.grid();
  out.pieces.reserve(cells.count());
  for (std::size_t number = 0; number < cells.count(); ++number) {
    const auto cell = cells.index_of(number);
    Bezier<R, N> piece(degrees, map.num_components(), map.is_rational());
    const Grid<N> grid = piece.grid();
    for (std::size_t i = 0; i < grid.count(); ++i) {
      auto index = grid.index_of(i);
      for (std::size_t a = 0; a < N; ++a) index[a] += first[a][cell[a]];
      const std::size_t offset = net.at(index);
      for (int c = 0; c < map.num_components(); ++c)
        piece.component(c)[i] = map.component(c)[offset];
    }
    out.pieces.push_back(std::move(piece));
  }
  return out;
}

// Compiled once, in rational_instances.cc.
extern template BSpline<Rational, 1> refine(const BSpline<Rational, 1>&, std::size_t,
                                            const std::vector<Rational>&);
extern template BSpline<Rational, 2> refine(const BSpline<Rational, 2>&, std::size_t,
                                            const std::vector<Rational>&);
extern template BSpline<Rational, 3> refine(const BSpline<Rational, 3>&, std::size_t,
                                            const std::vector<Rational>&);
extern template BezierPieces<Rational, 1> bezier_pieces(BSpline<Rational, 1>);
extern template BezierPieces<Rational, 2> bezier_pieces(BSpline<Rational, 2>);
extern template BezierPieces<Rational, 3> bezier_pieces(BSpline<Rational, 3>);

}  // namespace veritope
