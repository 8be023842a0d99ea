// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/exact_bernstein.h: sums, products and derivatives of scalar polynomials in Bernstein form over exact
// numbers, from which the solvers' equations are made; and their enclosures on small boxes.
#pragma once
#include <span>
#include <vector>

#include "interval/exact_box.h"
#include "interval/ring_numbers.h"
#include "splines/bezier.h"

namespace veritope {

/// A polynomial on [0,1]^N: one component.
template <std::size_t N>
using ExactPolynomial = Bezier<Rational, N>;

template <std::size_t N>
ExactPolynomial<N> product(const ExactPolynomial<N>& a, const ExactPolynomial<N>& b);
/// a + k b, with the larger of the degrees. REQUIRES polynomials; rational maps are added by splines/bezier_product.h,
/// whose name differs, so that no include decides which sum is meant.
template <std::size_t N>
ExactPolynomial<N> plus(const ExactPolynomial<N>& a, const ExactPolynomial<N>& b,
                        const Rational& k = Rational(1));
template <std::size_t N>
ExactPolynomial<N> derivative(const ExactPolynomial<N>& a, std::size_t axis);
/// Raises the degree along an axis by one; the polynomial is the same.
template <std::size_t N>
ExactPolynomial<N> raised(const ExactPolynomial<N>& a, std::size_t axis);
/// Component c of a map.
template <std::size_t N>
ExactPolynomial<N> scalar(const Bezier<Rational, N>& map, int c) {
  const auto values = map.component(c);
  return ExactPolynomial<N>(map.degrees(), 1, false,
                            std::vector<Rational>(values.begin(), values.end()));
}

/// The coefficients of the map restricted to a box, each to approximately 2^-precision of the largest. The box may
/// extend beyond [0,1]^N. REQUIRES a live ScopedUpward, and that no side of the box is a point.
template <std::size_t N>
Bezier<Interval, N> enclosed_on(const Bezier<Rational, N>& map, const ExactBox<N>& box,
                                int precision);

}  // namespace veritope
