// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/scaled_bernstein.h: Bernstein coefficients times their binomials, in which products are plain convolutions.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "splines/bezier.h"
#include "splines/binomial.h"
#include "splines/scaled_product.h"

namespace veritope {
namespace internal {

template <Ring R, std::size_t N, typename Factor>
void multiply_coefficients(Bezier<R, N>& map, Factor factor) {
  const Grid<N> grid = map.grid();
  for (std::size_t axis = 0; axis < N; ++axis) {
    const int degree = map.degree(axis);
    std::vector<R> factors;
    for (int i = 0; i <= degree; ++i) factors.push_back(factor(degree, i));
    const std::size_t stride = grid.stride(axis);
    for (int c = 0; c < map.num_components(); ++c) {
      const std::span<R> values = map.component(c);
      grid.for_each_line(axis, [&](std::size_t first) {
        for (int i = 1; i < degree; ++i) {  // the factors at both ends are 1
          R& value = values[first + static_cast<std::size_t>(i) * stride];
          value = value * factors[static_cast<std::size_t>(i)];
        }
      });
    }
  }
}

/// A map's numbers over one common positive denominator.
struct OverOne {
  std::vector<Integer> numerators;
  Integer denominator{1};

  explicit OverOne(std::span<const Rational> values) {
    for (const Rational& v : values)
      denominator *= divide_exactly(v.denominator(), gcd(denominator, v.denominator()));
    numerators.reserve(values.size());
    for (const Rational& v : values)
      numerators.push_back(v.numerator() * divide_exactly(denominator, v.denominator()));
  }
};

}  // namespace internal

/// Every coefficient times its binomials, one for each axis; the first and last of a line stay.
template <Ring R, std::size_t N>
Bezier<R, N> to_scaled(Bezier<R, N> map) {
  internal::multiply_coefficients(map, [](int n, int k) { return binomial_in<R>(n, k); });
  return map;
}
/// The inverse of to_scaled.
template <Ring R, std::size_t N>
Bezier<R, N> from_scaled(Bezier<R, N> map) {
  internal::multiply_coefficients(map, [](int n, int k) { return inverse_binomial_in<R>(n, k); });
  return map;
}

/// Adds to `out` the product of two polynomials, all three in scaled coefficients.
/// REQUIRES shapes with out.size[i] + 1 = a.size[i] + b.size[i].  @cost a.count() b.count() products
template <Ring R, std::size_t N>
void add_scaled_product(std::span<const R> a, const Grid<N>& a_grid, std::span<const R> b,
                        const Grid<N>& b_grid, std::span<R> out, const Grid<N>& out_grid) {
  if constexpr (std::same_as<R, Rational>) {
    // With one denominator there is a gcd for each sum, not for each term.
    const internal::OverOne p(a), q(b);
    std::vector<Integer> sums(out.size());
    internal::add_product_on_grids(p.numerators.data(), a_grid, q.numerators.data(), b_grid,
                                   sums.data(), out_grid);
    const Integer denominator = p.denominator * q.denominator;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += Rational(sums[i], denominator);
  } else {
    internal::add_product_on_grids(a.data(), a_grid, b.data(), b_grid, out.data(), out_grid);
  }
}

}  // namespace veritope
