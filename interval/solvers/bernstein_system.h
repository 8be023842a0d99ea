// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/bernstein_system.h: N polynomials in N variables in Bernstein form with interval coefficients, on
// one box, and the questions that the solver asks about them. All functions REQUIRE a live ScopedUpward.
#pragma once
#include <optional>
#include <utility>

#include "interval/ring_numbers.h"
#include "interval/solvers/krawczyk.h"
#include "splines/bezier.h"

namespace veritope {

/// What the examination of a box shows.
template <std::size_t N>
struct Examination {
  enum class Kind { kNoRoot, kOneRoot, kUnknown } kind = Kind::kUnknown;
  /// kOneRoot: the box, inflated by kInflation of its sides on each side, contains exactly one root. The root is simple
  /// and lies in this box, in coordinates in which the inflated box is [-1,1]^N. It may lie outside of the box
  /// examined.
  Box<N> root;
  std::size_t axis = 0;       ///< kUnknown: where to cut
  bool is_exhausted = false;  ///< kUnknown: rounding errors hide what would decide
};
inline constexpr double kInflation = 0.125;

/// The equations, N components on [0,1]^N, restricted to the two halves of an axis.
template <std::size_t N>
std::pair<Bezier<Interval, N>, Bezier<Interval, N>> halves(const Bezier<Interval, N>& system,
                                                           std::size_t axis);

/// Excludes roots by the signs of Bernstein coefficients of the equations and of combinations of them, proves one
/// root by Krawczyk's test in preconditioned form, or says where to cut. @cost O(N^2) passes over the coefficients.
template <std::size_t N>
Examination<N> examine(const Bezier<Interval, N>& system);

/// The elimination of the approximate mean of the Jacobian matrix over the box.
template <std::size_t N>
Elimination<N> elimination(const Bezier<Interval, N>& system);

/// matrix * equations.
template <std::size_t N>
Bezier<Interval, N> combined(const ApproxMatrix<N>& matrix, const Bezier<Interval, N>& system);

/// Enclosures of the derivatives over [0,1]^N by the hulls of their Bernstein coefficients.
template <std::size_t N>
IntervalMatrix<N> derivative_hulls(const Bezier<Interval, N>& system);

}  // namespace veritope
