// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/cell_expansion_internal.h: a polynomial of a span on its cells, as a sum of Legendre
// polynomials. Internal to solids/micro/measure.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "interval/ring_numbers.h"
#include "robust/rational.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// From Bernstein coefficients of a degree on [0, 1] to Legendre coefficients on intervals in it: one matrix for each
/// interval between neighbouring breaks, order + 1 rows of degree + 1 numbers.
/// REQUIRES rising breaks in [0, 1], order <= degree, and a live ScopedUpward.
std::vector<std::vector<Interval>> legendre_matrices(int degree, std::size_t order,
                                                     const std::vector<Rational>& breaks);

/// How far polynomials of the sum of degrees up to an order are from the polynomial on each of the cells; rising
/// orders. The last order is that from which on there is nothing left, or `most_order`.
/// `half_widths`: at least half the widths of the cells along each axis. REQUIRES one component, and a live
/// ScopedUpward.
std::vector<double> expansion_errors(const BezierVolume<Interval>& f,
                                     const std::array<double, 3>& half_widths,
                                     std::size_t most_order);

/// Finds these errors from the expansions of all cells in full: the least bounds of this kind.
/// @cost  for each cell the product of the degrees, times the greatest of them
std::vector<double> exact_expansion_errors(const BezierVolume<Interval>& f,
                                           const std::array<std::vector<Rational>, 3>& breaks,
                                           std::size_t most_order);

/// Replaces coefficients by their middles. Returns how far they were apart at most; infinite, with f in any state, if a
/// coefficient is not finite. REQUIRES one component.
double keep_midpoints(BezierVolume<Interval>& f);

/// An upper bound of |f| on the unit cube: the sum of the magnitudes of its Legendre coefficients. It is near where f
/// oscillates and Bernstein coefficients are much greater than values. REQUIRES one component, and a live ScopedUpward.
double greatest_value(BezierVolume<Interval> f);

/// The expansions of f on the cells of a span up to an order, row by row.
class CellExpansion {
 public:
  /// REQUIRES one component, breaks in [0, 1], and a live ScopedUpward.
  CellExpansion(const BezierVolume<Interval>& f, const std::array<std::vector<Rational>, 3>& breaks,
                std::size_t order);

  /// Work that cells (i, ., .) and (i, j, .) share.
  struct Sheet {
    std::vector<Interval> values;
  };
  struct Row {
    std::vector<Interval> values;
  };
  void enter_sheet(std::size_t i, Sheet& sheet) const;
  void enter_row(const Sheet& sheet, std::size_t j, Row& row) const;
  /// Coefficients of P_i(2x - 1) P_j(2y - 1) P_k(2z - 1) on cell k of the row, brought to the unit cube, in the
  /// order of moment_indices.
  void cell(const Row& row, std::size_t k, std::vector<Interval>& out) const;

 private:
  // Row (a, b) of values along the third axis, and where its coefficients go.
  struct Line {
    std::size_t a, b;
    std::vector<std::size_t> to;
  };
  std::size_t num_moments_;
  std::array<std::size_t, 3> size_;  // degrees + 1
  std::array<std::size_t, 3> rows_;  // of the matrices
  std::vector<Interval> values_;
  std::array<std::vector<std::vector<Interval>>, 3> matrices_;
  std::vector<Line> lines_;
};

}  // namespace veritope::internal
