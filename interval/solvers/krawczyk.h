// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/krawczyk.h: the existence and uniqueness test of the solvers, and the small matrices that
// precondition it. Source: [Neu90] 5.2 (Krawczyk, Moore). Proof: docs/THEORY.md, ROOT-1.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "interval/box.h"

namespace veritope {

/// No proof relies on these numbers: any will do, but good ones make tests succeed.
template <std::size_t N>
using ApproxMatrix = std::array<std::array<double, N>, N>;
template <std::size_t N>
using IntervalMatrix = std::array<std::array<Interval, N>, N>;

/// Gaussian elimination, with full pivoting, of an approximate Jacobian matrix: combinations of its rows.
template <std::size_t N>
struct Elimination {
  /// Row k has the factor 1 at one row of the matrix, others of approximately 1 in absolute value, and zero gradient in
  /// the first k pivot variables. The last row is the combination with the least gradient: where the Jacobian is nearly
  /// singular, it is the one that varies least.
  ApproxMatrix<N> combination{};
  std::optional<ApproxMatrix<N>> inverse;  ///< if no pivot vanishes
};
template <std::size_t N>
Elimination<N> eliminate(const ApproxMatrix<N>& matrix);

/// For a map g of the box X = [-1,1]^N with g(0) in `at_centre` and all derivatives over X in `derivatives`: returns a
/// box K in the interior of X if this proves that g has exactly one zero in X, that the zero is simple, and that the
/// zero lies in K; otherwise nothing. The test is K = -g(0) + (I - g'(X)) X. g should be preconditioned, with a
/// derivative near I. The test also holds for g that is continuous and only piecewise differentiable. REQUIRES a live
/// ScopedUpward.
template <std::size_t N>
std::optional<Box<N>> krawczyk(const std::array<Interval, N>& at_centre,
                               const IntervalMatrix<N>& derivatives);

}  // namespace veritope
