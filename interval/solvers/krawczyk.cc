// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/krawczyk.h"

#include <cmath>
#include <utility>

namespace veritope {
namespace {

// [matrix | I], reduced in place.
template <std::size_t N>
struct Tableau {
  ApproxMatrix<N> left, right{};
  std::array<std::size_t, N> column;  // the pivot variable of each row

  explicit Tableau(const ApproxMatrix<N>& matrix) : left(matrix) {
    for (std::size_t i = 0; i < N; ++i) right[i][i] = 1, column[i] = i;
  }
  // Brings the largest entry right of and below k to (k, k); false if all are 0 or not finite.
  bool pivot(std::size_t k) {
    std::size_t row = k, col = k;
    for (std::size_t i = k; i < N; ++i)
      for (std::size_t j = k; j < N; ++j)
        if (std::abs(left[i][j]) > std::abs(left[row][col])) row = i, col = j;
    std::swap(left[k], left[row]), std::swap(right[k], right[row]);
    for (auto& r : left) std::swap(r[k], r[col]);
    std::swap(column[k], column[col]);
    return std::isnormal(left[k][k]);
  }
  void subtract(std::size_t from, double factor, std::size_t row) {
    for (std::size_t j = 0; j < N; ++j) {
      left[from][j] -= factor * left[row][j];
      right[from][j] -= factor * right[row][j];
    }
  }
};

}  // namespace

template <std::size_t N>
Elimination<N> eliminate(const ApproxMatrix<N>& matrix) {
  Tableau<N> t(matrix);
  bool regular = true;
  for (std::size_t k = 0; k < N && regular; ++k) {
    regular = t.pivot(k);
    for (std::size_t i = k + 1; i < N && regular; ++i)
      t.subtract(i, t.left[i][k] / t.left[k][k], k);
  }
  Elimination<N> out;
  out.combination = t.right;
  if (!regular) return out;
  for (std::size_t k = N; k-- > 0;) {
    for (std::size_t j = 0; j < N; ++j) t.right[k][j] /= t.left[k][k];
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = 0; j < N; ++j) t.right[i][j] -= t.left[i][k] * t.right[k][j];
  }
  ApproxMatrix<N> inverse;
  for (std::size_t k = 0; k < N; ++k) inverse[t.column[k]] = t.right[k];
  for (const auto& row : inverse)
    for (const double v : row)
      if (!std::isfinite(v)) return out;
  out.inverse = inverse;
  return out;
}

template <std::size_t N>
std::optional<Box<N>> krawczyk(const std::array<Interval, N>& at_centre,
                               const IntervalMatrix<N>& derivatives) {
  const Interval side = Interval::from_bounds(-1, 1);
  Box<N> out;
  for (std::size_t i = 0; i < N; ++i) {
    out[i] = -at_centre[i];
    for (std::size_t j = 0; j < N; ++j)
      out[i] += (Interval(i == j ? 1 : 0) - derivatives[i][j]) * side;
  }
  if (out.is_empty() || !is_interior(out, Box<N>::filled(side))) return std::nullopt;
  return out;
}

#define VT_INSTANTIATE(N)                                    \
  template Elimination<N> eliminate(const ApproxMatrix<N>&); \
  template std::optional<Box<N>> krawczyk(const std::array<Interval, N>&, const IntervalMatrix<N>&);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
VT_INSTANTIATE(3)
VT_INSTANTIATE(4)
#undef VT_INSTANTIATE

}  // namespace veritope
