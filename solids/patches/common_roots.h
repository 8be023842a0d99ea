// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/common_roots.h: where several polynomials vanish together, exactly: which parameters a point has on a
// curve, or at which parameter a row of a patch is one point.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "robust/rational.h"

namespace veritope {

/// Coefficients of 1, t, t^2, ...; empty: zero. The last one is not 0.
using Polynomial = std::vector<Rational>;

/// The polynomial with these Bernstein coefficients over [0,1]; of degree n for n + 1 of them, or less.
Polynomial polynomial_of(std::span<const Rational> bernstein);

/// Different numbers of [0,1] at which all polynomials vanish.
struct CommonRoots {
  bool is_everywhere = false;  ///< all polynomials are zero; `roots` is then empty
  /// [a, a] is the root a. [a, b] with a < b holds one root, which is irrational or has a denominator of over 20 bits,
  /// and no other. Ascending; intervals may have ends in common, which are no roots.
  std::vector<std::array<Rational, 2>> roots;
  /// A polynomial without multiple roots, whose roots in [0,1] these are; at the ends of [a, b] its signs differ. Empty
  /// if there is no root.
  Polynomial polynomial;
};
/// REQUIRES at least one polynomial. @cost a greatest common divisor of each two, then a Sturm chain
CommonRoots common_roots(std::span<const Polynomial> polynomials);

}  // namespace veritope
