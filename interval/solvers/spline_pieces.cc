// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/spline_pieces.h"

#include <string>
#include <utility>

#include "interval/relations.h"

namespace veritope {
namespace {

constexpr int kPointPrecision = 256;

// The pieces from index first[a] to last[a] of each axis.
template <std::size_t N>
ExactPieces<N> sub_grid(const ExactPieces<N>& all, const std::array<std::size_t, N>& first,
                        const std::array<std::size_t, N>& last) {
  ExactPieces<N> out;
  for (std::size_t a = 0; a < N; ++a)
    out.breaks[a].assign(all.breaks[a].begin() + static_cast<std::ptrdiff_t>(first[a]),
                         all.breaks[a].begin() + static_cast<std::ptrdiff_t>(last[a]) + 1);
  const Grid<N> grid = out.grid();
  for (std::size_t i = 0; i < grid.count(); ++i) {
    auto cell = grid.index_of(i);
    for (std::size_t a = 0; a < N; ++a) cell[a] += first[a];
    out.pieces.push_back(all.at(cell));
  }
  return out;
}

// Cut at the breaks whose multiplicity exceeds the degree by `excess` or more.
template <std::size_t N>
std::vector<SmoothPart<N>> parts_of(const BSpline<Rational, N>& map, int excess) {
  const ExactPieces<N> all = bezier_pieces(map);
  const auto excess_at = [&](std::size_t a, std::size_t i) {
    return multiplicity(map.axis(a), all.breaks[a][i]) - map.axis(a).degree;
  };
  std::array<std::vector<std::size_t>, N> cuts;
  Grid<N> parts;
  for (std::size_t a = 0; a < N; ++a) {
    cuts[a].push_back(0);
    for (std::size_t i = 1; i + 1 < all.breaks[a].size(); ++i)
      if (excess_at(a, i) >= excess) cuts[a].push_back(i);
    cuts[a].push_back(all.breaks[a].size() - 1);
    parts.size[a] = cuts[a].size() - 1;
  }
  std::vector<SmoothPart<N>> out;
  for (std::size_t i = 0; i < parts.count(); ++i) {
    std::array<std::size_t, N> first, last;
    std::array<bool, N> is_first;
    const auto number = parts.index_of(i);
    for (std::size_t a = 0; a < N; ++a) {
      first[a] = cuts[a][number[a]], last[a] = cuts[a][number[a] + 1];
      is_first[a] = number[a] == 0 || excess_at(a, first[a]) > 0;  // torn: nothing is shared
    }
    out.push_back({sub_grid(all, first, last), is_first});
  }
  return out;
}

}  // namespace

template <std::size_t N>
std::vector<SmoothPart<N>> smooth_parts(const BSpline<Rational, N>& map) {
  return parts_of(map, 0);
}
template <std::size_t N>
std::vector<ExactPieces<N>> connected_parts(const BSpline<Rational, N>& map) {
  std::vector<ExactPieces<N>> out;
  for (SmoothPart<N>& part : parts_of(map, 1)) out.push_back(std::move(part.pieces));
  return out;
}

template <std::size_t N>
Status check_weights(const BSpline<Rational, N>& map) {
  if (!map.is_rational()) return ok_status();
  for (const Rational& w : map.component(map.num_components() - 1))
    if (w.sign() != Sign::kPositive)
      return Error{Code::kBadArgument, {}, "a weight is " + w.to_string() + ", not positive"};
  return ok_status();
}

template <std::size_t N>
requires(N > 1) ExactPieces<N - 1> border(const ExactPieces<N>& map, std::size_t axis, bool high) {
  ExactPieces<N - 1> out;
  for (std::size_t a = 0, b = 0; a < N; ++a)
    if (a != axis) out.breaks[b++] = map.breaks[a];
  const Grid<N - 1> cells = out.grid();
  for (std::size_t i = 0; i < cells.count(); ++i) {
    const auto cell = cells.index_of(i);
    std::array<std::size_t, N> index;
    for (std::size_t a = 0, b = 0; a < N; ++a)
      index[a] = a != axis ? cell[b++] : high ? map.breaks[a].size() - 2 : 0;
    const Bezier<Rational, N>& from = map.at(index);
    std::array<int, N - 1> degrees;
    for (std::size_t a = 0, b = 0; a < N; ++a)
      if (a != axis) degrees[b++] = from.degree(a);
    Bezier<Rational, N - 1> to(degrees, from.num_components(), from.is_rational());
    const Grid<N> grid = from.grid();
    for (int c = 0; c < from.num_components(); ++c) {
      std::size_t k = 0;
      for (std::size_t o = 0; o < grid.count(); ++o)
        if (grid.index_of(o)[axis] == (high ? grid.size[axis] - 1 : 0))
          to.component(c)[k++] = from.component(c)[o];
    }
    out.pieces.push_back(std::move(to));
  }
  return out;
}

template <std::size_t N>
ExactBox<N> place_of(const ExactPieces<N>& map, const std::array<std::size_t, N>& cell) {
  ExactBox<N> out;
  for (std::size_t a = 0; a < N; ++a) out[a] = {map.breaks[a][cell[a]], map.breaks[a][cell[a] + 1]};
  return out;
}

template <std::size_t N>
std::vector<Interval> hull_of(const Bezier<Interval, N>& piece) {
  std::vector<Interval> out(static_cast<std::size_t>(piece.dimension()), Interval::empty());
  const std::size_t count = piece.grid().count();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < out.size(); ++c) {
      Interval v = piece.component(static_cast<int>(c))[i];
      if (piece.is_rational()) {
        const Interval w = piece.component(piece.num_components() - 1)[i];
        v = w.sign() == Sign3::kPositive ? v / w : Interval::entire();
      }
      out[c] = hull(out[c], v);
    }
  return out;
}

template <std::size_t N>
Bezier<Interval, N> enclosed(const Bezier<Rational, N>& map) {
  Bezier<Interval, N> out(map.degrees(), map.num_components(), map.is_rational());
  for (std::size_t i = 0; i < map.coefficients().size(); ++i)
    out.coefficients()[i] = enclose(map.coefficients()[i]);
  return out;
}

template <std::size_t N>
std::vector<Interval> points_of(const ExactPieces<N>& map, const ExactBox<N>& box) {
  std::vector<Interval> out(static_cast<std::size_t>(map.pieces[0].dimension()), Interval::empty());
  const Grid<N> cells = map.grid();
  for (std::size_t i = 0; i < cells.count(); ++i) {
    const ExactBox<N> place = place_of(map, cells.index_of(i));
    if (!touches(place, box)) continue;
    ExactBox<N> local = seen_from(intersection(box, place), place);
    for (ExactInterval& s : local.side)  // a side that is a point is widened a little
      if (s.lo == s.hi) {
        const Rational little = Rational::power_of_two(-200);
        s = {s.lo - little, s.hi + little};
      }
    const auto part = hull_of(enclosed_on(map.pieces[i], local, kPointPrecision));
    for (std::size_t c = 0; c < out.size(); ++c) out[c] = hull(out[c], part[c]);
  }
  return out;
}

template ExactPieces<1> border(const ExactPieces<2>&, std::size_t, bool);
#define VT_INSTANTIATE(N)                                                                  \
  template std::vector<SmoothPart<N>> smooth_parts(const BSpline<Rational, N>&);           \
  template std::vector<ExactPieces<N>> connected_parts(const BSpline<Rational, N>&);       \
  template Status check_weights(const BSpline<Rational, N>&);                              \
  template ExactBox<N> place_of(const ExactPieces<N>&, const std::array<std::size_t, N>&); \
  template std::vector<Interval> points_of(const ExactPieces<N>&, const ExactBox<N>&);     \
  template std::vector<Interval> hull_of(const Bezier<Interval, N>&);                      \
  template Bezier<Interval, N> enclosed(const Bezier<Rational, N>&);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
#undef VT_INSTANTIATE

}  // namespace veritope
