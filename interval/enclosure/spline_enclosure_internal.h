// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/spline_enclosure_internal.h: any formula in the derivatives of a spline, enclosed over a box of
// parameters.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "interval/enclosure/bernstein_box.h"
#include "interval/enclosure/spline_enclosure.h"
#include "interval/gradient.h"
#include "interval/upward.h"

namespace veritope::internal {

template <std::size_t N>
using MultiIndex = std::array<int, N>;

template <std::size_t N>
int total(const MultiIndex<N>& a) {
  int sum = 0;
  for (const int k : a) sum += k;
  return sum;
}
/// All multi-indices with a total of at most `order`, by ascending total.
template <std::size_t N>
std::vector<MultiIndex<N>> multi_indices(int order) {
  std::vector<MultiIndex<N>> out;
  for (int sum = 0; sum <= order; ++sum) {
    MultiIndex<N> at{};
    for (;;) {
      if (total<N>(at) == sum) out.push_back(at);
      std::size_t a = N;
      while (a > 0 && at[a - 1] == order) at[--a] = 0;
      if (a == 0) break;
      ++at[a - 1];
    }
  }
  return out;
}

template <std::size_t N>
struct EnclosureData {
  struct Cell {
    std::vector<Bezier<Interval, N>> derivatives;  // in the order of `indices`
  };
  int max_order = 0, dimension = 0;
  bool is_rational = false;
  std::vector<MultiIndex<N>> indices;
  struct Axis {
    std::vector<Interval> begin, length;       // of the cells
    std::vector<double> break_up, break_down;  // rounded breaks
  };
  std::array<Axis, N> axes;
  std::vector<Cell> cells;  // the last axis fastest

  std::size_t index_of(const MultiIndex<N>& order) const {
    std::size_t i = 0;
    while (indices[i] != order) ++i;
    return i;
  }
};

/// Enclosures of the derivatives of all coordinates up to an order.
template <std::size_t N>
struct Jets {
  const EnclosureData<N>* data;
  std::vector<Interval> values;  // [index][coordinate]

  const Interval& at(const MultiIndex<N>& order, std::size_t c) const {
    return values[data->index_of(order) * static_cast<std::size_t>(data->dimension) + c];
  }
};
/// The jets over `local`, a box of [0,1]^N of the cell. For polynomial maps, only `base` and its derivatives are
/// computed; the others are empty. REQUIRES order <= max_order.
template <std::size_t N>
Jets<N> jets_over(const EnclosureData<N>& data, std::size_t cell, const Box<N>& local, int order,
                  const MultiIndex<N>& base);

/// What formulas see: the derivative of a coordinate, as an Interval ...
template <std::size_t N>
struct ValueView {
  using Number = Interval;
  const Jets<N>& jets;
  Interval operator()(const MultiIndex<N>& order, std::size_t c) const { return jets.at(order, c); }
};
/// ... or with its slopes.
template <std::size_t N>
struct SlopeView {
  using Number = Gradient<N>;
  const Jets<N>& jets;
  Gradient<N> operator()(MultiIndex<N> order, std::size_t c) const {
    Gradient<N> out{jets.at(order, c), {}};
    for (std::size_t a = 0; a < N; ++a) {
      ++order[a];
      out.slope[a] = jets.at(order, c);
      --order[a];
    }
    return out;
  }
};

/// One part of a box of parameters: the cell, and the part in its own coordinates.
template <std::size_t N>
struct CellPart {
  std::size_t cell;
  std::array<std::size_t, N> index;
  Box<N> local;
};
/// The cells that a box meets or touches. @error as SplineEnclosure::value.
template <std::size_t N>
Result<std::vector<CellPart<N>>> parts_of(const EnclosureData<N>& data, const Box<N>& at,
                                          int order);

/// F, the formula, has std::vector<Number> operator()(view), which reads derivatives up to `order`, and base(): all
/// that the formula reads are derivatives of that one. `over`: the jets over the part, one order higher.
template <std::size_t N, typename F>
std::vector<Interval> mean_value(const EnclosureData<N>& data, const CellPart<N>& part,
                                 const F& formula, int order, const Jets<N>& over) {
  Box<N> middle;
  for (std::size_t a = 0; a < N; ++a) middle[a] = Interval(mid(part.local[a]));
  const Jets<N> there = jets_over(data, part.cell, middle, order, formula.base());
  std::vector<Interval> out = formula(ValueView<N>{there});
  const auto slopes = formula(SlopeView<N>{over});
  for (std::size_t k = 0; k < out.size(); ++k)
    for (std::size_t a = 0; a < N; ++a)
      out[k] +=
          slopes[k].slope[a] * (data.axes[a].length[part.index[a]] * (part.local[a] - middle[a]));
  // Where the formula is not defined at the middle (a singular point), this form gives no bound.
  for (Interval& v : out)
    if (v.is_empty()) v = Interval::entire();
  return out;
}
template <std::size_t N, typename F>
std::vector<Interval> enclosed(const EnclosureData<N>& data, const CellPart<N>& part,
                               const F& formula, int order, EnclosureForm form) {
  const int highest = form == EnclosureForm::kHull ? order : order + 1;
  const Jets<N> over = jets_over(data, part.cell, part.local, highest, formula.base());
  if (form == EnclosureForm::kMeanValue) return mean_value(data, part, formula, order, over);
  std::vector<Interval> out = formula(ValueView<N>{over});
  if (form == EnclosureForm::kHull) return out;
  const std::vector<Interval> other = mean_value(data, part, formula, order, over);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = intersection(out[k], other[k]);
  return out;
}
/// The hull over the cells that the box meets. `order`: the highest derivative that the formula reads.
template <std::size_t N, typename F>
Result<std::vector<Interval>> enclosed(const EnclosureData<N>& data, const Box<N>& at,
                                       const F& formula, int order, EnclosureForm form) {
  const ScopedUpward upward;
  const auto parts = parts_of(data, at, form == EnclosureForm::kHull ? order : order + 1);
  if (!parts) return parts.error();
  std::vector<Interval> out;
  for (const CellPart<N>& part : parts.value()) {
    const std::vector<Interval> here = enclosed(data, part, formula, order, form);
    if (out.empty()) out.assign(here.size(), Interval::empty());
    for (std::size_t k = 0; k < here.size(); ++k) out[k] = hull(out[k], here[k]);
  }
  return out;
}

}  // namespace veritope::internal
