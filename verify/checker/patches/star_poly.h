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
// Calls f(index, a, b) for each coefficient; a b is the product of its binomials.
template <class F>
void each_pair_of_binomials(const Shape& s, F f) {
  int64_t a = 1;
  for (int i = 0; i <= s.p; a = a * (s.p - i) / (i + 1), ++i) {
    const int most = s.is_triangle ? s.p - i : s.q;
    int64_t b = 1;
    for (int j = 0; j <= most; b = b * (most - j) / (j + 1), ++j)
      f(size_t(s.is_triangle ? s.at3(i, j) : s.at(i, j)), a, b);
  }
}
template <class F>
void each_binomial(const Shape& s, F f) {  // f(index, a b)
  each_pair_of_binomials(s, [&](size_t i, int64_t a, int64_t b) { f(i, Big(a) * Big(b)); });
}
// 2^this is at least the product of the binomials of each coefficient.
inline int bits_of_binomials(const Shape& s) {
  int bits = 0;
  each_pair_of_binomials(s, [&](size_t, int64_t a, int64_t b) {
    bits = std::max(bits, bit_length(uint64_t(a)) + bit_length(uint64_t(b)));
  });
  return bits;
}
Poly product(const Poly& a, const Poly& b);
Poly combined(const Poly& a, const Poly& b, int sign);  // a + sign b
// The polynomial with these Bernstein coefficients, or, if the axis is 0 or 1, its derivative along it up to a positive
// factor.
Poly polynomial(const Shape& s, const std::vector<Big>& coefficients, int axis);
