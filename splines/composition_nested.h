// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/composition_nested.h: the one algorithm behind all compositions of Bezier maps, over any arithmetic of
// polynomials.
//
// With homogeneous inner coordinates x_m, weight w (1 for a polynomial map) and q_m = w - x_m,
//   w^(a_1 + ... + a_M) T(x / w) = sum over k of P_k prod_m C(a_m, k_m) x_m^k_m q_m^(a_m - k_m).
// The last variable comes first: its basis polynomials are made once for all components and added up with the
// coefficients as factors. Every other variable is replaced by de Casteljau's triangle with polynomials in the place of
// numbers, F_i <- q F_i + x F_(i + 1): each product has one factor of the inner map's own low degree. For a tricubic
// map in a tricubic volume that is 13 million products of numbers per component; with powers of x and q made beforehand
// it would be 43 million.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "splines/de_casteljau_line.h"

namespace veritope::internal {

/// The inner map, prepared. Algebra: see PlainAlgebra.
template <typename Algebra, std::size_t M>
struct InnerMap {
  using Polynomial = typename Algebra::Polynomial;
  std::array<Polynomial, M> x, q;
};

/// The blend q F + x G of de Casteljau's scheme with polynomials in the place of numbers.
template <typename Algebra>
struct PolynomialBlend {
  using Polynomial = typename Algebra::Polynomial;
  const Algebra& algebra;
  const Polynomial& q;
  const Polynomial& x;

  void into_first(Polynomial& f, const Polynomial& g) const { f = algebra.blend(f, q, g, x); }
};

/// C(a, i) x^i q^(a - i) for i = 0..a, by the recurrence of Bernstein polynomials.
template <typename Algebra>
std::vector<typename Algebra::Polynomial> basis_polynomials(const Algebra& algebra, int a,
                                                            const typename Algebra::Polynomial& x,
                                                            const typename Algebra::Polynomial& q) {
  std::vector<typename Algebra::Polynomial> basis{algebra.constant_one()};
  for (int level = 1; level <= a; ++level) {
    basis.push_back(algebra.product(basis.back(), x));
    for (std::size_t i = static_cast<std::size_t>(level) - 1; i > 0; --i)
      basis[i] = algebra.blend(basis[i], q, basis[i - 1], x);
    basis[0] = algebra.product(basis[0], q);
  }
  return basis;
}

/// Composes one component. coefficients: those of the outer map, the last variable fastest; last_basis:
/// basis_polynomials of the last variable.
template <typename Algebra, std::size_t M>
typename Algebra::Polynomial compose_component(
    const Algebra& algebra, const std::array<int, M>& degrees,
    std::span<const typename Algebra::Scalar> coefficients, const InnerMap<Algebra, M>& inner,
    std::span<const typename Algebra::Polynomial> last_basis) {
  std::vector<typename Algebra::Polynomial> f;
  for (std::size_t i = 0; i < coefficients.size(); i += last_basis.size())
    f.push_back(algebra.linear(coefficients.subspan(i, last_basis.size()), last_basis));
  for (std::size_t m = M - 1; m-- > 0;) {
    const auto a = static_cast<std::size_t>(degrees[m]);
    std::vector<typename Algebra::Polynomial> next;
    for (std::size_t first = 0; first < f.size(); first += a + 1) {
      keep_right(f.data() + first, 1, degrees[m],
                 PolynomialBlend<Algebra>{algebra, inner.q[m], inner.x[m]});
      next.push_back(std::move(f[first]));
    }
    f = std::move(next);
  }
  return std::move(f.front());
}

}  // namespace veritope::internal
