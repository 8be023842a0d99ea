// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/inside/grid_spans_internal.h"

#include <algorithm>

namespace veritope::internal {

SpanPart span_part(const std::vector<Rational>& k, const Rational& lo, const Rational& hi) {
  const auto next = std::upper_bound(k.begin() + 1, k.end() - 1, lo);
  SpanPart out;
  out.span = static_cast<std::size_t>(next - k.begin()) - 1;
  const Rational length = *next - *(next - 1);
  out.lo = (lo - *(next - 1)) / length;
  out.hi = (hi - *(next - 1)) / length;
  out.lo_bound = enclose(out.lo);
  out.hi_bound = enclose(out.hi);
  return out;
}

AxisParts axis_parts(const std::vector<Rational>& knots, const std::vector<Rational>& breaks) {
  AxisParts out;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    out.cells.push_back(span_part(knots, breaks[i], breaks[i + 1]));
    if (i == 0 || out.cells[i].span != out.cells[i - 1].span) out.first_of_span.push_back(i);
  }
  out.first_of_span.push_back(out.cells.size());
  return out;
}

}  // namespace veritope::internal
