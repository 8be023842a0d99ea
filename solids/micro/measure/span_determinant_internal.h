// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/span_determinant_internal.h: the determinant of a volume's map between knots, as a polynomial
// and a bound of what it leaves out. Internal to solids/micro/measure.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "interval/ring_numbers.h"
#include "solids/micro/microstructure.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// The cells of a grid between two neighbouring knots along each axis.
struct CellSpan {
  std::array<std::size_t, 3> knots{};                 ///< knots[k] < knots[k + 1] of each axis
  std::array<std::array<std::size_t, 2>, 3> cells{};  ///< the first one, and one past the last
};
/// All of a grid, in the order of their first cells. REQUIRES a valid grid of the volume.
std::vector<CellSpan> spans_of(const VVolume& volume, const MicroGrid& grid);

/// Where the breaks of a span's cells lie, if the knots are brought to 0 and 1. One more than cells.
std::vector<Rational> breaks_in_span(const VVolume& volume, const MicroGrid& grid,
                                     const CellSpan& span, std::size_t axis);

/// det(T_u, T_v, T_w) for the parameters of the span brought to [0, 1]: it differs from the polynomial of one component
/// by at most `error` at each point of the span, for polynomial maps by rounding only.
struct SpanDeterminant {
  BezierVolume<Interval> polynomial{{0, 0, 0}, 1, false};
  double error = 0;  ///< infinite if a weight is not proved positive
};

/// The error is at most `enough` times the greatest coefficient, if the degrees allow that.
/// REQUIRES a map to space, polynomial or rational, and a live ScopedUpward.
/// @cost  for polynomial maps of degree p approximately (p + 1)^6 products; rational ones are interpolated in degrees
///        up to 24 along the axes on which their weights depend, with (degree + 1)^3 (4p)^3 products for the error
SpanDeterminant span_determinant(const VVolume& volume, const CellSpan& span, double enough);

/// max |f| of the Bernstein coefficients, an upper bound for the polynomial.
double greatest_coefficient(const BezierVolume<Interval>& f);

}  // namespace veritope::internal
