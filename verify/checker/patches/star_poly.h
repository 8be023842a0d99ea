// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_poly.h: polynomials on nodes and patches, given by their Bernstein coefficients times
// binomials (of a triangle: trinomials): the product of two polynomials is then the product of such
// coefficients, and their signs are those of the Bernstein coefficients.
#pragma once
#include "star.h"

struct Poly {
  Shape shape;
  std::vector<Big> c;
};
int64_t binomial(int n, int k);
// Calls f(index, factor) for each coefficient; factor is the product of its binomials.
template <class F>
void each_binomial(const Shape& s, F f) {
  if (s.is_triangle) {
    for (int j = 0; j <= s.p; ++j)
      for (int k = 0; j + k <= s.p; ++k)
        f(size_t(s.at3(j, k)), Big(binomial(s.p, j)) * Big(binomial(s.p - j, k)));
  } else {
    for (int i = 0; i <= s.p; ++i)
      for (int j = 0; j <= s.q; ++j)
        f(size_t(s.at(i, j)), Big(binomial(s.p, i)) * Big(binomial(s.q, j)));
  }
}
Poly product(const Poly& a, const Poly& b);
Poly combined(const Poly& a, const Poly& b, int sign);  // a + sign b
// The polynomial with these Bernstein coefficients, or, if the axis is 0 or 1, its derivative along it up to a positive
// factor.
Poly polynomial(const Shape& s, const std::vector<Big>& coefficients, int axis);
