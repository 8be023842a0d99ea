// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/piece_cutter.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "solids/vmodel/exact_double_internal.h"
#include "splines/blossom_weights.h"
#include "splines/scaled_bernstein.h"

namespace veritope {
namespace {

struct Rounded {
  double value, error;
};
Rounded rounded_number(const Rational& x) {
  if (const auto exact = internal::as_double(x)) return {*exact, 0};
  const double v = nearest_double(x);
  return {v, std::abs(v) * 0x1p-52 + 0x1p-1000};
}

// Coefficients of the last axis but `axis` move: to[i] = sum of m[i][j] from[j] along it.
std::vector<Integer> along_axis(const std::vector<Integer>& from, const Grid<3>& grid,
                                std::size_t axis, const std::vector<Integer>& matrix) {
  const std::size_t n = grid.size[axis], stride = grid.stride(axis);
  std::vector<Integer> to(from.size());
  grid.for_each_line(axis, [&](std::size_t first) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (!matrix[i * n + j].is_zero())
          to[first + i * stride].add_product(matrix[i * n + j], from[first + j * stride]);
  });
  return to;
}

}  // namespace

PieceCutter::PieceCutter(const VVolume& cell, const std::array<std::vector<Rational>, 3>& breaks)
    : cell_(&cell) {
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& axis = cell.axis(a);
    const auto p = static_cast<std::size_t>(axis.degree);
    for (std::size_t i = 0; i + 1 < breaks[a].size(); ++i) {
      const Rational &low = breaks[a][i], &high = breaks[a][i + 1];
      const std::size_t span = internal::find_span(axis, low);
      Cut cut{span - p, axis.knots[span + 1 - p] == low && axis.knots[span + p] == high, {}};
      if (!cut.is_identity) {
        std::vector<Rational> arguments(p, low), rows;
        for (std::size_t k = 0; k <= p; ++k) {
          const auto row = internal::blossom_weights<Rational>(axis, span, arguments);
          rows.insert(rows.end(), row.begin(), row.end());
          if (k < p) arguments[k] = high;
        }
        cut.matrix = internal::OverOne(rows).numerators;
      }
      cuts_[a].push_back(std::move(cut));
    }
  }
}

Grid<3> PieceCutter::grid() const { return {{cuts_[0].size(), cuts_[1].size(), cuts_[2].size()}}; }

bool PieceCutter::is_whole(const std::array<std::size_t, 3>& piece) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (!cuts_[a][piece[a]].is_identity) return false;
  return true;
}

std::vector<const Rational*> PieceCutter::box(const std::array<std::size_t, 3>& piece) const {
  const Grid<3> net = cell_->grid();
  std::array<std::size_t, 3> first{}, size{};
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = cuts_[a][piece[a]].first;
    size[a] = static_cast<std::size_t>(cell_->axis(a).degree) + 1;
  }
  std::vector<const Rational*> out;
  const int count = cell_->is_rational() ? 4 : 3;
  out.reserve(static_cast<std::size_t>(count) * size[0] * size[1] * size[2]);
  for (int c = 0; c < count; ++c) {
    const auto values = cell_->component(c == 3 ? cell_->num_components() - 1 : c);
    for (std::size_t i = 0; i < size[0]; ++i)
      for (std::size_t j = 0; j < size[1]; ++j) {
        const std::size_t at = net.at({first[0] + i, first[1] + j, first[2]});
        for (std::size_t k = 0; k < size[2]; ++k) out.push_back(&values[at + k]);
      }
  }
  return out;
}

BezierVolume<Integer> PieceCutter::exact(const std::array<std::size_t, 3>& piece) const {
  std::vector<Rational> numbers;
  for (const Rational* x : box(piece)) numbers.push_back(*x);
  const int count = cell_->is_rational() ? 4 : 3;
  BezierVolume<Integer> out({cell_->axis(0).degree, cell_->axis(1).degree, cell_->axis(2).degree},
                            count, cell_->is_rational(), internal::OverOne(numbers).numerators);
  if (is_whole(piece)) return out;
  for (int c = 0; c < count; ++c) {
    const auto component = out.component(c);
    std::vector<Integer> values(component.begin(), component.end());
    for (std::size_t a = 0; a < 3; ++a)
      if (!cuts_[a][piece[a]].is_identity)
        values = along_axis(values, out.grid(), a, cuts_[a][piece[a]].matrix);
    std::move(values.begin(), values.end(), component.begin());
  }
  return out;
}

RoundedPiece PieceCutter::rounded(const std::array<std::size_t, 3>& piece) const {
  const int count = cell_->is_rational() ? 4 : 3;
  RoundedPiece out{{{cell_->axis(0).degree, cell_->axis(1).degree, cell_->axis(2).degree},
                    count,
                    cell_->is_rational()},
                   {}};
  const auto to = out.map.coefficients();
  const std::size_t size = out.map.grid().count();
  if (is_whole(piece)) {
    const auto from = box(piece);
    for (std::size_t i = 0; i < to.size(); ++i) {
      const Rounded x = rounded_number(*from[i]);
      to[i] = x.value;
      out.error[i / size] = std::max(out.error[i / size], x.error);
    }
    return out;
  }
  const BezierVolume<Integer> exact_map = exact(piece);
  const auto from = exact_map.coefficients();
  std::uint64_t bits = 0;
  for (const Integer& x : from) bits = std::max(bits, x.bit_length());
  const std::uint64_t shift = bits > 62 ? bits - 62 : 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    Integer x = from[i];
    if (shift > 0) x.shift_right(shift);  // loses less than 1
    to[i] = static_cast<double>(x.to_int64());
    const double error =
        (shift > 0 ? 1.0 : 0.0) + (x.bit_length() > 53 ? std::abs(to[i]) * 0x1p-52 : 0.0);
    out.error[i / size] = std::max(out.error[i / size], error);
  }
  return out;
}

}  // namespace veritope
