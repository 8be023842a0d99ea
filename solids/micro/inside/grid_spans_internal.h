// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/grid_spans_internal.h: where the cells of a grid lie between the knots of their volume. Internal
// to solids/micro/inside.
#pragma once
#include <cstddef>
#include <vector>

#include "interval/interval.h"
#include "robust/rational.h"

namespace veritope::internal {

/// Where a part [lo, hi] of an axis lies: the number of its knot span, and both ends in units of the span.
struct SpanPart {
  std::size_t span = 0;
  Rational lo, hi;
  Interval lo_bound, hi_bound;
};
/// REQUIRES rising knots, and lo <= hi in one span between them.
SpanPart span_part(const std::vector<Rational>& knots, const Rational& lo, const Rational& hi);

/// The cells of a grid along an axis, in units of the knot spans.
struct AxisParts {
  std::vector<SpanPart> cells;
  std::vector<std::size_t> first_of_span;  ///< and the number of cells
};
AxisParts axis_parts(const std::vector<Rational>& knots, const std::vector<Rational>& breaks);

}  // namespace veritope::internal
