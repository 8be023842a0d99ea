// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/jacobian_net.h: the Bernstein coefficients of a determinant that has the sign of det J on a piece.
// N = -det(F, F_u, F_v, F_w) over the homogeneous coefficients F; for polynomial pieces the determinant of the
// derivatives. docs/certificates/vmodel.md, section 5. Bound: docs/bounds/jacobian_net.md.
#pragma once
#include <cstddef>
#include <vector>

#include "robust/integer.h"
#include "solids/vmodel/piece_cutter.h"
#include "splines/bezier.h"
#include "splines/grid.h"

namespace veritope {

/// Bernstein coefficients of N up to one positive factor, in the degrees 3p - 1, or 4p - 1 for rational pieces.
struct ExactJacobian {
  Grid<3> grid;
  std::vector<Integer> values;
};
/// These coefficients in binary64: every exact one, up to one positive factor, is within `error`, which is infinite or
/// NaN where nothing is known.
struct RoundedJacobian {
  Grid<3> grid;
  std::vector<double> values;
  double error = 0;

  /// Whether all exact coefficients are proved positive (after multiplication by `sign`, 1 or -1).
  bool is_positive(int sign) const;
};

/// @cost m m2 products of integers, for m control points and m2 coefficients of the squares; six times as many if the
/// piece is rational
ExactJacobian exact_jacobian(const BezierVolume<Integer>& piece);
/// The rounding mode of the calling thread does not matter. In a build without IEEE arithmetic the error is infinite.
RoundedJacobian rounded_jacobian(const RoundedPiece& piece);

namespace internal {
/// The most roundings that a term of a coefficient goes through: docs/bounds/jacobian_net.md.
int jacobian_roundings(const Grid<3>& grid, bool is_rational);
/// Computes N in doubles without any bound, for the benchmark.
std::vector<double> plain_jacobian(const BezierVolume<double>& piece);
}  // namespace internal

}  // namespace veritope
