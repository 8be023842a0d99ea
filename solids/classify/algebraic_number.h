// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/algebraic_number.h: real roots of polynomials with integer coefficients, one or two.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "robust/rational.h"

namespace veritope {

/// The rational number lo = hi, or a root between lo and hi, where the polynomial has different signs; or a number of
/// which no polynomial is known, only that it is in [lo, hi], lo < hi.
struct AlgebraicNumber {
  std::vector<Integer>
      polynomial;  ///< coefficients of 1, t, t^2, ...; of a rational number q t - p; empty: not known
  Rational lo, hi;

  bool is_rational() const { return lo == hi; }
  bool is_known() const { return !polynomial.empty(); }
};

/// Two numbers, of which one may depend on the other.
struct AlgebraicPair {
  std::array<AlgebraicNumber, 2> numbers;
  /// Coefficients of 1, t, t^2, ...: if not empty, number `dependent` is this polynomial of the other number, whose
  /// polynomial is that of numbers; then conjugates of both belong together. Otherwise all conjugates do.
  std::vector<Rational> relation;
  std::size_t dependent = 0;

  const AlgebraicNumber& operator[](std::size_t k) const { return numbers[k]; }
  bool is_rational() const { return numbers[0].is_rational() && numbers[1].is_rational(); }
};

/// Both numbers as polynomials of one: a root of `modulus` between lo and hi, where it has different signs.
struct PrimitivePair {
  std::vector<Rational> modulus;  ///< coefficients of 1, t, t^2, ...
  Rational lo, hi;
  std::array<std::vector<Rational>, 2> numbers;  ///< of lower degrees
};
/// The first root is u, v, or u + j v for a small j. Nothing if the numbers are rational, if a polynomial is not known,
/// or if no small j serves.
/// @cost  some elimination in as many unknowns as the product of both degrees
std::optional<PrimitivePair> primitive_pair(const AlgebraicPair& pair);
/// a b, divided by the modulus of degree d: the remainder, d coefficients. REQUIRES a modulus of degree 1 or more.
std::vector<Rational> product_modulo(const std::vector<Rational>& a, const std::vector<Rational>& b,
                                     const std::vector<Rational>& modulus);

}  // namespace veritope
