// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/polynomial_filter.h: products of scaled polynomials in binary64, as filters over arrays with zeros between the rows.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "splines/scaled_polynomial.h"

namespace veritope::internal {

/// The arithmetic of composition_nested.h in doubles. Polynomials of fewer than three variables have leading sizes of 1.
/// Every coefficient is a sum of products in this order: within a row of the small factor, rows of both products in turn, planes.
struct DoubleAlgebra {
  using Scalar = double;
  using Polynomial = ScaledPolynomial<double, 3>;

  Polynomial constant_one() const { return {{{1, 1, 1}}, {1.0}}; }
  Polynomial product(const Polynomial& a, const Polynomial& q) const;
  Polynomial blend(const Polynomial& a, const Polynomial& q, const Polynomial& b,
                   const Polynomial& w) const;
  Polynomial linear(std::span<const double> factor, std::span<const Polynomial> p) const;

  /// The most roundings, products and sums counted alike, that one term of a blend goes through, for factors q, w of this grid.
  static int blend_roundings(const Grid<3>& q) {
    return static_cast<int>(q.size[0] + 2 * q.size[1] + q.size[2]) - 2;
  }
};

}  // namespace veritope::internal
