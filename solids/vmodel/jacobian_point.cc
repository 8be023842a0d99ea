// SPDX-License-Identifier: LGPL-3.0-or-later
// The determinant at a point of a cell.
#include <array>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

#include "interval/interval.h"
#include "interval/upward.h"
#include "solids/vmodel/exact_double_internal.h"
#include "solids/vmodel/jacobian_sign.h"
#include "splines/blossom_weights.h"

namespace veritope {
namespace {

template <typename R>
struct AxisWeights {
  std::size_t first = 0;
  std::vector<R> value, slope;  // slope: of the derivative times a positive number
};

template <typename R>
R point_number(const Rational& x) {
  if constexpr (std::same_as<R, Rational>) {
    return x;
  } else {
    const auto exact = internal::as_double(x);
    return exact ? Interval(*exact) : enclose(x);
  }
}

AxisWeights<Rational> axis_weights(const KnotAxis<Rational>& axis, const Rational& t) {
  const auto p = static_cast<std::size_t>(axis.degree);
  const std::size_t span = internal::find_span(axis, t);
  std::vector<Rational> arguments(p, t);
  AxisWeights<Rational> out{
      span - p, internal::blossom_weights<Rational>(axis, span, arguments), {}};
  arguments[0] = axis.knots[span + 1];
  out.slope = internal::blossom_weights<Rational>(axis, span, arguments);
  arguments[0] = axis.knots[span];
  const auto at_begin = internal::blossom_weights<Rational>(axis, span, arguments);
  for (std::size_t i = 0; i <= p; ++i) out.slope[i] -= at_begin[i];
  return out;
}

template <typename R>
AxisWeights<R> in_numbers(const AxisWeights<Rational>& w) {
  AxisWeights<R> out{w.first, {}, {}};
  for (const Rational& x : w.value) out.value.push_back(point_number<R>(x));
  for (const Rational& x : w.slope) out.slope.push_back(point_number<R>(x));
  return out;
}

// F and the three derivatives up to positive factors.
template <typename R>
std::array<std::array<R, 4>, 4> rows_at(const VVolume& cell,
                                        const std::array<AxisWeights<R>, 3>& w) {
  std::array<std::array<R, 4>, 4> rows{};
  const Grid<3> grid = cell.grid();
  const int count = cell.is_rational() ? 4 : 3;
  for (int c = 0; c < count; ++c) {
    const auto net = cell.component(c == 3 ? cell.num_components() - 1 : c);
    std::array<R, 4> total{};
    for (std::size_t i = 0; i < w[0].value.size(); ++i) {
      R value{}, by_v{}, by_w{};
      for (std::size_t j = 0; j < w[1].value.size(); ++j) {
        R line{}, line_slope{};
        const std::size_t at = grid.at({w[0].first + i, w[1].first + j, w[2].first});
        for (std::size_t k = 0; k < w[2].value.size(); ++k) {
          const R x = point_number<R>(net[at + k]);
          line += w[2].value[k] * x;
          line_slope += w[2].slope[k] * x;
        }
        value += w[1].value[j] * line;
        by_v += w[1].slope[j] * line;
        by_w += w[1].value[j] * line_slope;
      }
      total[0] += w[0].value[i] * value;
      total[1] += w[0].slope[i] * value;
      total[2] += w[0].value[i] * by_v;
      total[3] += w[0].value[i] * by_w;
    }
    for (std::size_t r = 0; r < 4; ++r) rows[r][static_cast<std::size_t>(c)] = total[r];
  }
  return rows;
}

// The determinant of three rows, in the columns 0 to 3 without `left_out`.
template <typename R>
R determinant_of(const std::array<std::array<R, 4>, 4>& rows, std::size_t left_out) {
  std::array<std::size_t, 3> c{};
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if (i != left_out) c[n++] = i;
  const auto &u = rows[1], &v = rows[2], &w = rows[3];
  return u[c[0]] * (v[c[1]] * w[c[2]] - v[c[2]] * w[c[1]]) +
         u[c[1]] * (v[c[2]] * w[c[0]] - v[c[0]] * w[c[2]]) +
         u[c[2]] * (v[c[0]] * w[c[1]] - v[c[1]] * w[c[0]]);
}

template <typename R>
R jacobian_at(const VVolume& cell, const std::array<AxisWeights<R>, 3>& weights) {
  const auto rows = rows_at(cell, weights);
  if (!cell.is_rational()) return determinant_of(rows, 3);
  R out{};  // -det: the first row times its cofactors
  for (std::size_t c = 0; c < 4; ++c) {
    const R term = rows[0][c] * determinant_of(rows, c);
    out = c % 2 == 0 ? R(out - term) : R(out + term);
  }
  return out;
}

}  // namespace

Sign jacobian_sign(const VVolume& cell, const std::array<Rational, 3>& at) {
  std::array<AxisWeights<Rational>, 3> exact;
  for (std::size_t a = 0; a < 3; ++a) exact[a] = axis_weights(cell.axis(a), at[a]);
  {
    const ScopedUpward upward;
    const Sign3 sign =
        jacobian_at<Interval>(cell, {in_numbers<Interval>(exact[0]), in_numbers<Interval>(exact[1]),
                                     in_numbers<Interval>(exact[2])})
            .sign();
    if (is_certain(sign)) return to_sign(sign);
  }
  return jacobian_at<Rational>(cell, exact).sign();
}

}  // namespace veritope
