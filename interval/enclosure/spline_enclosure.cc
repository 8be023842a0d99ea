// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/enclosure/spline_enclosure.h"

#include <algorithm>

#include "interval/enclosure/spline_enclosure_internal.h"
#include "splines/binomial.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace internal {
namespace {

Interval as_interval(const Rational& v) { return enclose(v); }
Interval as_interval(const Interval& v) { return v; }
bool is_positive(const Rational& v) { return v.sign() == Sign::kPositive; }
bool is_positive(const Interval& v) { return v.sign() == Sign3::kPositive; }

template <typename R, std::size_t N>
Bezier<Interval, N> as_intervals(const Bezier<R, N>& map) {
  std::vector<Interval> out;
  for (const R& v : map.coefficients()) out.push_back(as_interval(v));
  return Bezier<Interval, N>(map.degrees(), map.num_components(), map.is_rational(),
                             std::move(out));
}

// The derivatives of X / w from those of X and w: Leibniz' rule for X = w S.
template <std::size_t N>
void divide_by_weight(const EnclosureData<N>& data, std::size_t count,
                      const std::vector<Interval>& weight, std::vector<Interval>& values) {
  const auto dimension = static_cast<std::size_t>(data.dimension);
  for (std::size_t i = 1; i < count; ++i)
    for (std::size_t j = 1; j <= i; ++j) {
      MultiIndex<N> rest = data.indices[i];
      double times = 1;
      bool is_below = true;
      for (std::size_t a = 0; a < N; ++a) {
        const int k = data.indices[j][a];
        is_below = is_below && k <= rest[a];
        if (is_below) times *= static_cast<double>(binomial_int64(rest[a], k)), rest[a] -= k;
      }
      if (!is_below) continue;
      const Interval factor = Interval(times) * weight[j];
      const std::size_t from = data.index_of(rest) * dimension;
      for (std::size_t c = 0; c < dimension; ++c)
        values[i * dimension + c] -= factor * values[from + c];
      if (j == i)
        for (std::size_t c = 0; c < dimension; ++c)
          values[i * dimension + c] = values[i * dimension + c] / weight[0];
    }
}

template <typename R, std::size_t N>
EnclosureData<N> make_data(const BSpline<R, N>& map, int max_order) {
  EnclosureData<N> data;
  data.max_order = max_order, data.dimension = map.dimension();
  data.is_rational = map.is_rational();
  data.indices = multi_indices<N>(max_order);
  const BezierPieces<R, N> pieces = bezier_pieces(map);
  for (std::size_t a = 0; a < N; ++a) {
    auto& axis = data.axes[a];
    for (std::size_t i = 0; i < pieces.breaks[a].size(); ++i) {
      const Rational& at = pieces.breaks[a][i];
      axis.break_up.push_back(round_up(at)), axis.break_down.push_back(round_down(at));
      if (i + 1 == pieces.breaks[a].size()) break;
      axis.begin.push_back(enclose(at));
      axis.length.push_back(enclose(pieces.breaks[a][i + 1] - at));
    }
  }
  const Grid<N> grid = pieces.grid();
  for (std::size_t number = 0; number < pieces.pieces.size(); ++number) {
    std::array<Rational, N> length;
    std::size_t rest = number;
    for (std::size_t a = N; a-- > 0; rest /= grid.size[a]) {
      const std::size_t i = rest % grid.size[a];
      length[a] = pieces.breaks[a][i + 1] - pieces.breaks[a][i];
    }
    std::vector<Bezier<R, N>> exact;
    typename EnclosureData<N>::Cell cell;
    for (const MultiIndex<N>& index : data.indices) {
      if (total<N>(index) == 0) {
        exact.push_back(pieces.pieces[number]);
      } else {
        std::size_t axis = 0;
        while (index[axis] == 0) ++axis;
        MultiIndex<N> below = index;
        --below[axis];
        exact.push_back(cell_derivative(exact[data.index_of(below)], axis, length[axis]));
      }
      cell.derivatives.push_back(as_intervals(exact.back()));
    }
    data.cells.push_back(std::move(cell));
  }
  return data;
}

}  // namespace

template <std::size_t N>
Jets<N> jets_over(const EnclosureData<N>& data, std::size_t cell, const Box<N>& local, int order,
                  const MultiIndex<N>& base) {
  const auto dimension = static_cast<std::size_t>(data.dimension);
  Jets<N> out{&data, {}};
  std::vector<Interval> weight;
  bool is_point = true;
  for (const Interval& side : local) is_point = is_point && is_singleton(side);
  std::size_t count = 0;
  for (; count < data.indices.size() && total<N>(data.indices[count]) <= order; ++count) {
    bool is_read = true;
    for (std::size_t a = 0; a < N; ++a) is_read = is_read && data.indices[count][a] >= base[a];
    if (!is_read && !data.is_rational) {
      out.values.insert(out.values.end(), dimension, Interval::empty());
      continue;
    }
    const Bezier<Interval, N>& whole = data.cells[cell].derivatives[count];
    std::array<Interval, N> point;
    for (std::size_t a = 0; a < N; ++a) point[a] = local[a];
    std::vector<Interval> sides;
    if (is_point) {
      sides = evaluate(whole, point);
    } else {
      const Bezier<Interval, N> piece = on_box(whole, local);
      for (int c = 0; c < piece.num_components(); ++c) sides.push_back(hull_of(piece, c));
      if (data.is_rational && count == 0) {  // projected control points: positive weights
        const auto w = piece.component(data.dimension);
        for (std::size_t c = 0; c < dimension; ++c) {
          const auto x = piece.component(static_cast<int>(c));
          sides[c] = Interval::empty();
          for (std::size_t i = 0; i < x.size(); ++i) sides[c] = hull(sides[c], x[i] / w[i]);
        }
      }
    }
    if (data.is_rational) {
      weight.push_back(sides.back());
      sides.pop_back();
      if (is_point && count == 0)
        for (Interval& side : sides) side = side / weight[0];
    }
    out.values.insert(out.values.end(), sides.begin(), sides.end());
  }
  if (data.is_rational) divide_by_weight(data, count, weight, out.values);
  return out;
}

template <std::size_t N>
Result<std::vector<CellPart<N>>> parts_of(const EnclosureData<N>& data, const Box<N>& at,
                                          int order) {
  if (order > data.max_order)
    return bad_argument("derivatives of order " + std::to_string(order) +
                        " are needed, and were prepared up to " + std::to_string(data.max_order));
  std::array<std::vector<std::pair<std::size_t, Interval>>, N> along;
  for (std::size_t a = 0; a < N; ++a) {
    const auto& axis = data.axes[a];
    const Interval side = at[a];
    if (side.is_empty() ||
        !is_subset(side, Interval::from_bounds(axis.break_up.front(), axis.break_down.back())))
      return bad_argument("parameter " + std::to_string(a) + ", " + to_string(side) +
                          ", is empty or leaves the domain");
    const Interval unit = Interval::from_bounds(0, 1);
    for (std::size_t i = 0; i < axis.begin.size(); ++i) {
      if (!(axis.break_up[i] <= side.hi() && side.lo() <= axis.break_down[i + 1])) continue;
      along[a].emplace_back(i, intersection(unit, (side - axis.begin[i]) / axis.length[i]));
    }
  }
  std::vector<CellPart<N>> out(1);
  out[0].cell = 0;
  for (std::size_t a = 0; a < N; ++a) {
    std::vector<CellPart<N>> next;
    for (const CellPart<N>& part : out)
      for (const auto& [i, local] : along[a]) {
        next.push_back(part);
        next.back().cell = part.cell * data.axes[a].begin.size() + i;
        next.back().index[a] = i, next.back().local[a] = local;
      }
    out = std::move(next);
  }
  return out;
}

namespace {

template <std::size_t N>
struct DerivativeFormula {
  MultiIndex<N> order;
  std::size_t dimension;
  const MultiIndex<N>& base() const { return order; }
  template <typename View>
  std::vector<typename View::Number> operator()(const View& view) const {
    std::vector<typename View::Number> out;
    for (std::size_t c = 0; c < dimension; ++c) out.push_back(view(order, c));
    return out;
  }
};

template <typename R, std::size_t N>
Result<std::shared_ptr<const EnclosureData<N>>> checked_data(const BSpline<R, N>& map,
                                                             int max_order) {
  if (max_order < 0 || max_order > SplineEnclosure<N>::kMaxOrder)
    return Error{Code::kBadArgument,
                 {},
                 "derivatives of order " + std::to_string(max_order) + " are not offered: 0 to 3"};
  const ScopedUpward upward;
  if (map.is_rational()) {
    const auto weights = map.component(map.num_components() - 1);
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (!is_positive(weights[i]))
        return Error{Code::kBadArgument,
                     {},
                     "weight " + std::to_string(i) + ", " + to_string(as_interval(weights[i])) +
                         ", is not positive"};
  }
  return std::shared_ptr<const EnclosureData<N>>(
      std::make_shared<EnclosureData<N>>(make_data(map, max_order)));
}

}  // namespace
}  // namespace internal

template <std::size_t N>
Result<SplineEnclosure<N>> SplineEnclosure<N>::prepare(const BSpline<Rational, N>& map,
                                                       int max_order) {
  auto data = internal::checked_data(map, max_order);
  if (!data) return data.error();
  return SplineEnclosure(std::move(*data));
}
template <std::size_t N>
Result<SplineEnclosure<N>> SplineEnclosure<N>::prepare(const BSpline<Interval, N>& map,
                                                       int max_order) {
  auto data = internal::checked_data(map, max_order);
  if (!data) return data.error();
  return SplineEnclosure(std::move(*data));
}

template <std::size_t N>
int SplineEnclosure<N>::dimension() const {
  return data_->dimension;
}
template <std::size_t N>
int SplineEnclosure<N>::max_order() const {
  return data_->max_order;
}
template <std::size_t N>
Box<N> SplineEnclosure<N>::domain() const {
  Box<N> out;
  for (std::size_t a = 0; a < N; ++a)
    out[a] =
        Interval::from_bounds(data_->axes[a].break_up.front(), data_->axes[a].break_down.back());
  return out;
}

template <std::size_t N>
Result<std::vector<Interval>> SplineEnclosure<N>::derivative(const std::array<int, N>& order,
                                                             const Box<N>& at,
                                                             EnclosureForm form) const {
  for (const int k : order)
    if (k < 0) return Error{Code::kBadArgument, {}, "a derivative of order " + std::to_string(k)};
  const internal::DerivativeFormula<N> formula{order, static_cast<std::size_t>(data_->dimension)};
  return internal::enclosed(*data_, at, formula, internal::total<N>(order), form);
}

#define VT_INSTANTIATE(N)                                                                         \
  template class SplineEnclosure<N>;                                                              \
  template internal::Jets<N> internal::jets_over(const EnclosureData<N>&, std::size_t,            \
                                                 const Box<N>&, int, const MultiIndex<N>&);       \
  template Result<std::vector<internal::CellPart<N>>> internal::parts_of(const EnclosureData<N>&, \
                                                                         const Box<N>&, int);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
VT_INSTANTIATE(3)
#undef VT_INSTANTIATE

}  // namespace veritope
