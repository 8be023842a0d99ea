// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/piecewise_roots.h: all roots of N continuous, piecewise polynomial equations in N unknowns:
// equations of B-splines, cell by cell, with roots on borders of cells reported once. Design:
// docs/design/0012-certified-solvers.md.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "interval/solvers/exact_bernstein.h"
#include "interval/solvers/root_report.h"
#include "robust/base/result.h"

namespace veritope {

/// The equations on the grid of cells [breaks[0][i], breaks[0][i + 1]] x ...; the functions must be continuous on the
/// whole domain.
template <std::size_t N>
struct PiecewiseEquations {
  using Cell = std::array<std::size_t, N>;

  std::array<std::vector<Rational>, N> breaks;  // increasing, at least two
  /// N scalar polynomials of [0,1]^N, the cell's own coordinates.
  std::function<std::vector<ExactPolynomial<N>>(const Cell&)> equations;
  /// Optional: true if the cell is proved to be free of roots at lower cost than from the equations. It is called with
  /// a live ScopedUpward.
  std::function<bool(const Cell&)> is_free;

  ExactBox<N> domain() const;
  ExactBox<N> place(const Cell& cell) const;
};

/// Like polynomial_roots, but in the coordinates of the breaks. Beyond the domain the equations are continued by the
/// formulas of the outermost cells. A root at an inner border is proved by Krawczyk's test over all cells that its box
/// meets.
/// @error as polynomial_roots
template <std::size_t N>
Result<RootReport<N>> piecewise_roots(const PiecewiseEquations<N>& system,
                                      const SolverOptions& options = {});

}  // namespace veritope
