// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/algebraic_number.h: a real root of a polynomial with integer coefficients.
#pragma once
#include <vector>

#include "robust/rational.h"

namespace veritope {

/// The rational number lo = hi, or a root between lo and hi, where the polynomial has different signs.
struct AlgebraicNumber {
  std::vector<Integer>
      polynomial;  ///< coefficients of 1, t, t^2, ...; of a rational number q t - p
  Rational lo, hi;

  bool is_rational() const { return lo == hi; }
};

}  // namespace veritope
