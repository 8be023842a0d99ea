// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/polynomial_filter.h: products of scaled polynomials in binary64, as filters over arrays with zeros between
// the rows.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "robust/fixed_int.h"
#include "splines/scaled_polynomial.h"

namespace veritope::internal {

/// Results are made kLanes at a time, in registers of two, so that there are several chains of dependent sums.
struct DoubleLanes {
  using Scalar = double;
  typedef double Pair __attribute__((vector_size(16)));
  static constexpr std::size_t kPairs = 4, kLanes = 2 * kPairs;

  Pair p[kPairs] = {};

  [[gnu::always_inline]] void add(const DoubleLanes& b) {
    VT_UNROLL for (std::size_t i = 0; i < kPairs; ++i) p[i] += b.p[i];
  }
  /// this = or += factor * (from[0], from[1], ...)
  template <bool Add>
  [[gnu::always_inline]] void multiply(const double* from, double factor) {
    VT_UNROLL for (std::size_t i = 0; i < kPairs; ++i) {
      Pair v;
      std::memcpy(&v, from + 2 * i, sizeof v);
      if constexpr (Add) {
        p[i] += v * factor;
      } else {
        p[i] = v * factor;
      }
    }
  }
  [[gnu::always_inline]] void store(double* to, std::size_t count) const {
    std::memcpy(to, p, count * sizeof(double));
  }
};

/// The arithmetic of composition_nested.h in the numbers of Lanes: doubles, or what a test counts in their place.
/// Polynomials of fewer than three variables have leading sizes of 1. Every coefficient is a sum of products in this
/// order: within a row of the small factor, rows of both products in turn, planes. A polynomial of degree 3 in 3
/// variables is read once for 64 products per result.
template <typename Lanes>
struct FilterAlgebra {
  using Scalar = typename Lanes::Scalar;
  using Polynomial = ScaledPolynomial<Scalar, 3>;

  Polynomial constant_one() const { return {{{1, 1, 1}}, {Scalar(1)}}; }
  Polynomial product(const Polynomial& a, const Polynomial& q) const {
    const Spread spread(a, q.grid);
    return filtered<1>({&spread}, {q.c.data()}, q.grid);
  }
  Polynomial blend(const Polynomial& a, const Polynomial& q, const Polynomial& b,
                   const Polynomial& w) const {
    const Spread of_a(a, q.grid), of_b(b, q.grid);
    return filtered<2>({&of_a, &of_b}, {q.c.data(), w.c.data()}, q.grid);
  }
  Polynomial linear(std::span<const Scalar> factor, std::span<const Polynomial> p) const {
    Polynomial out{p[0].grid, {}};
    for (const Scalar& v : p[0].c) out.c.push_back(factor[0] * v);
    for (std::size_t i = 1; i < p.size(); ++i)
      for (std::size_t j = 0; j < out.c.size(); ++j) out.c[j] += factor[i] * p[i].c[j];
    return out;
  }

 private:
  // The large factor's coefficients at their places in the product's array, after as many zeros as the small factor
  // reaches back.
  struct Spread {
    Grid<3> grid;  // of the product
    std::size_t front;
    std::vector<Scalar> c;

    Spread(const Polynomial& p, const Grid<3>& small)
        : grid(product_grid(p.grid, small)),
          front(grid.at({small.size[0] - 1, small.size[1] - 1, small.size[2] - 1})),
          c(front + grid.count() + Lanes::kLanes, Scalar(0)) {
      const Scalar* row = p.c.data();
      for (std::size_t i = 0; i < p.grid.size[0]; ++i)
        for (std::size_t j = 0; j < p.grid.size[1]; ++j, row += p.grid.size[2])
          std::copy(row, row + p.grid.size[2], c.data() + front + grid.at({i, j, 0}));
    }
    const Scalar* at(std::size_t place) const { return c.data() + front + place; }
  };

  // sum += the sum over k of q[k] a[-k]
  [[gnu::always_inline]] static void add_row(Lanes& sum, const Scalar* a, const Scalar* q,
                                             std::size_t count) {
    Lanes row;
    row.template multiply<false>(a, q[0]);
    for (std::size_t k = 1; k < count; ++k) row.template multiply<true>(a - k, q[k]);
    sum.add(row);
  }

  // The sum of the products of spread polynomials and small ones of the grid `small`.
  template <std::size_t Factors>
  static Polynomial filtered(const std::array<const Spread*, Factors>& a,
                             const std::array<const Scalar*, Factors>& q, const Grid<3>& small) {
    Polynomial out{a[0]->grid, std::vector<Scalar>(a[0]->grid.count())};
    const std::size_t count = out.c.size(), row = out.grid.size[2], plane = out.grid.stride(0);
    for (std::size_t first = 0; first < count; first += Lanes::kLanes) {
      Lanes sum;
      std::size_t place = 0;  // in the small factors
      for (std::size_t i = 0; i < small.size[0]; ++i) {
        Lanes of_plane;
        for (std::size_t j = 0; j < small.size[1]; ++j, place += small.size[2])
          for (std::size_t f = 0; f < Factors; ++f)
            add_row(of_plane, a[f]->at(first) - i * plane - j * row, q[f] + place, small.size[2]);
        sum.add(of_plane);
      }
      sum.store(out.c.data() + first, std::min(Lanes::kLanes, count - first));
    }
    return out;
  }
};

using DoubleAlgebra = FilterAlgebra<DoubleLanes>;

/// The most roundings that one term of a sum of `products` (1 or 2) products goes through, for small factors of this
/// grid: one for the multiplication, and then one fewer than there are summands in its row, rows in its plane, and
/// planes.
inline int filter_roundings(const Grid<3>& small, int products) {
  return static_cast<int>(small.size[0] + small.size[2]) +
         products * static_cast<int>(small.size[1]) - 2;
}

}  // namespace veritope::internal
