// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/scaled_product.h: products of polynomials in scaled Bernstein form are convolutions of their
// coefficients; this is the convolution, for any numbers, and for coefficients on boxes as well as on triangles.
// Design: docs/design/0023-one-toolbox-of-splines.md.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "splines/grid.h"

namespace veritope::internal {

/// sum += a b, without a temporary number where the ring allows.
template <typename S>
void add_product(S& sum, const S& a, const S& b) {
  if constexpr (requires { sum.add_product(a, b); }) {
    sum.add_product(a, b);
  } else if constexpr (requires { sum += a * b; }) {
    sum += a * b;
  } else {
    sum = sum + a * b;
  }
}

/// `size` coefficients one after the other, the first at `first`. Row m of one factor times row n of the other one
/// falls into row m + n of the product, coefficient i times coefficient j into its coefficient i + j.
struct ScaledRow {
  std::size_t number, first, size;
};

/// Adds the product of two polynomials to `out`, whose row m begins at row_begin(m). The terms of each coefficient
/// are added in the order of the first factor's coefficients.  @cost a product of numbers for every pair of
/// coefficients
template <typename S, typename RowBegin>
void add_product_of_rows(const S* a, std::span<const ScaledRow> a_rows, const S* b,
                         std::span<const ScaledRow> b_rows, S* out, RowBegin row_begin) {
  for (const ScaledRow& m : a_rows)
    for (std::size_t i = 0; i < m.size; ++i) {
      const S& factor = a[m.first + i];
      for (const ScaledRow& n : b_rows) {
        const S* const from = b + n.first;
        S* const to = out + row_begin(m.number + n.number) + i;
        for (std::size_t j = 0; j < n.size; ++j) add_product(to[j], factor, from[j]);
      }
    }
}

/// The rows of a grid, numbered as in the grid `out`, which is at least as large.
template <std::size_t N>
std::vector<ScaledRow> rows_within(const Grid<N>& grid, const Grid<N>& out) {
  const std::size_t size = grid.size[N - 1], count = grid.count();
  std::vector<ScaledRow> rows;
  for (std::size_t first = 0; first < count; first += size)
    rows.push_back({out.at(grid.index_of(first)) / out.size[N - 1], first, size});
  return rows;
}
/// out += a b for coefficients on grids. REQUIRES out.size[i] + 1 = a.size[i] + b.size[i].
template <typename S, std::size_t N>
void add_product_on_grids(const S* a, const Grid<N>& a_grid, const S* b, const Grid<N>& b_grid,
                          S* out, const Grid<N>& out_grid) {
  const auto a_rows = rows_within(a_grid, out_grid), b_rows = rows_within(b_grid, out_grid);
  const std::size_t size = out_grid.size[N - 1];
  add_product_of_rows<S>(a, a_rows, b, b_rows, out, [size](std::size_t m) { return m * size; });
}

/// out += a b for triangles in the order of triangle_index: rows of constant j + k. `out` has the degree a_degree +
/// b_degree.
template <typename S>
void add_product_on_triangles(const S* a, int a_degree, const S* b, int b_degree, S* out) {
  const auto begin = [](std::size_t row) { return row * (row + 1) / 2; };
  const auto rows = [&](int degree) {
    std::vector<ScaledRow> all;
    for (std::size_t r = 0; r <= static_cast<std::size_t>(degree); ++r)
      all.push_back({r, begin(r), r + 1});
    return all;
  };
  add_product_of_rows<S>(a, rows(a_degree), b, rows(b_degree), out, begin);
}

}  // namespace veritope::internal
