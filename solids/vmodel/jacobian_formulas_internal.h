// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/jacobian_formulas_internal.h: the determinant of docs/certificates/vmodel.md, section 5, in scaled
// Bernstein form, over any algebra of polynomials. A test runs it on numbers that count roundings.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "splines/lines.h"
#include "splines/scaled_polynomial.h"

namespace veritope::internal {

template <typename S>
using JacobianFactor = ScaledPolynomial<S, 3>;
/// The components of F or of a derivative.
template <typename S>
using JacobianRow = std::vector<JacobianFactor<S>>;

template <typename S>
JacobianFactor<S> negated_factor(JacobianFactor<S> p) {
  for (S& x : p.c) x = -x;
  return p;
}

/// p_i q_j - p_j q_i
template <typename Algebra, typename S = typename Algebra::Scalar>
JacobianFactor<S> minor_of(const Algebra& algebra, const JacobianRow<S>& p, const JacobianRow<S>& q,
                           std::size_t i, std::size_t j) {
  return algebra.blend(p[i], q[j], negated_factor(p[j]), q[i]);
}

template <typename S>
JacobianFactor<S> sum_of_factors(JacobianFactor<S> a, const JacobianFactor<S>& b) {
  for (std::size_t i = 0; i < a.c.size(); ++i) accumulate(a.c[i], b.c[i]);
  return a;
}

/// The determinant of three derivatives.
template <typename Algebra, typename S = typename Algebra::Scalar>
JacobianFactor<S> determinant3(const Algebra& algebra, const JacobianRow<S>& u,
                               const JacobianRow<S>& v, const JacobianRow<S>& w) {
  const auto x = minor_of(algebra, u, v, 1, 2), y = minor_of(algebra, u, v, 2, 0),
             z = minor_of(algebra, u, v, 0, 1);
  return sum_of_factors(algebra.blend(x, w[0], y, w[1]), algebra.product(z, w[2]));
}

/// -det(f, u, v, w): the first row times the cofactors. Small factors come last, which costs least.
template <typename Algebra, typename S = typename Algebra::Scalar>
JacobianFactor<S> determinant4(const Algebra& algebra, const JacobianRow<S>& f,
                               const JacobianRow<S>& u, const JacobianRow<S>& v,
                               const JacobianRow<S>& w) {
  JacobianFactor<S> minors[4][4];  // of v and w
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      minors[i][j] = minor_of(algebra, v, w, i, j);
      minors[j][i] = negated_factor(minors[i][j]);
    }
  // The determinant of u, v, w without column `out`, with the sign that it has in the result.
  const auto cofactor = [&](std::size_t out) {
    std::size_t c[3], n = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (i != out) c[n++] = i;
    if (out % 2 == 0) std::swap(c[0], c[1]);
    return sum_of_factors(algebra.blend(minors[c[1]][c[2]], u[c[0]], minors[c[2]][c[0]], u[c[1]]),
                          algebra.product(minors[c[0]][c[1]], u[c[2]]));
  };
  return sum_of_factors(algebra.blend(cofactor(0), f[0], cofactor(1), f[1]),
                        algebra.blend(cofactor(2), f[2], cofactor(3), f[3]));
}

}  // namespace veritope::internal
