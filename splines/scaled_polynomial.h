// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/scaled_polynomial.h: polynomials of N variables in scaled Bernstein form: the coefficient of x^i (1 - x)^(n -
// i), that is, the Bernstein coefficient times C(n, i), in each variable. Products are convolutions, and no number is
// divided.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "robust/integer.h"
#include "splines/binomial.h"
#include "splines/grid.h"
#include "splines/ring.h"
#include "splines/scaled_product.h"

namespace veritope::internal {

template <typename S, std::size_t N>
struct ScaledPolynomial {
  Grid<N> grid;  // degrees + 1
  std::vector<S> c;
};

/// The grid of a product.
template <std::size_t N>
Grid<N> product_grid(const Grid<N>& a, const Grid<N>& b) {
  Grid<N> g;
  for (std::size_t i = 0; i < N; ++i) g.size[i] = a.size[i] + b.size[i] - 1;
  return g;
}

/// visit(index, offset) for every entry of the grid, in order.
template <std::size_t N, typename Visit>
void for_each_index(const Grid<N>& grid, Visit visit) {
  std::array<std::size_t, N> index{};
  for (std::size_t offset = 0; offset < grid.count(); ++offset) {
    visit(index, offset);
    for (std::size_t a = N; a-- > 0;) {
      if (++index[a] < grid.size[a]) break;
      index[a] = 0;
    }
  }
}

/// out += a b. REQUIRES out.grid = product_grid(a.grid, b.grid). @cost a product of numbers for every pair of
/// coefficients
template <typename S, std::size_t N>
void accumulate_product(ScaledPolynomial<S, N>& out, const ScaledPolynomial<S, N>& a,
                        const ScaledPolynomial<S, N>& b) {
  add_product_on_grids(b.c.data(), b.grid, a.c.data(), a.grid, out.c.data(), out.grid);
}

/// C(n_1, i_1) C(n_2, i_2) ... for every entry of a grid of n_j + 1 entries; the numbers are the ring's knots, or
/// integers.
template <typename Number, std::size_t N>
std::vector<Number> binomial_grid(const Grid<N>& grid) {
  std::array<std::vector<Number>, N> rows;
  for (std::size_t a = 0; a < N; ++a)
    for (const Integer& b : binomial_row(static_cast<int>(grid.size[a]) - 1)) {
      if constexpr (std::same_as<Number, Integer>) {
        rows[a].push_back(b);
      } else {
        rows[a].push_back(knot_of<Number>(b));
      }
    }
  std::vector<Number> out;
  out.reserve(grid.count());
  for_each_index(grid, [&](const std::array<std::size_t, N>& index, std::size_t) {
    Number product = rows[0][index[0]];
    for (std::size_t a = 1; a < N; ++a) product = product * rows[a][index[a]];
    out.push_back(product);
  });
  return out;
}

/// The plain arithmetic of composition_nested.h, for any ring and for integers.
template <typename S, std::size_t N>
struct PlainAlgebra {
  using Scalar = S;
  using Polynomial = ScaledPolynomial<S, N>;

  S one;

  Polynomial constant_one() const {
    Polynomial p;
    p.grid.size.fill(1);
    p.c.assign(1, one);
    return p;
  }
  /// a q
  Polynomial product(const Polynomial& a, const Polynomial& q) const {
    Polynomial out{product_grid(a.grid, q.grid), {}};
    out.c.assign(out.grid.count(), S());
    accumulate_product(out, a, q);
    return out;
  }
  /// a q + b w. REQUIRES a and b of the same degrees, q and w too.
  Polynomial blend(const Polynomial& a, const Polynomial& q, const Polynomial& b,
                   const Polynomial& w) const {
    Polynomial out = product(a, q);
    accumulate_product(out, b, w);
    return out;
  }
  /// sum of factor[i] p[i]. REQUIRES p not empty, all of the same degrees.
  Polynomial linear(std::span<const S> factor, std::span<const Polynomial> p) const {
    Polynomial out{p[0].grid, {}};
    out.c.assign(out.grid.count(), S());
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < out.c.size(); ++j) add_product(out.c[j], factor[i], p[i].c[j]);
    return out;
  }
};

}  // namespace veritope::internal
