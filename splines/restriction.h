// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/restriction.h: a line of Bernstein coefficients restricted to a part [a, b]: which of the two cuts comes
// first, and where they are. Restrictions in all layers follow this rule. Design:
// docs/design/0023-one-toolbox-of-splines.md.
#pragma once
#include <cstddef>

#include "splines/de_casteljau_line.h"

namespace veritope::internal {

/// The order of the two cuts, and whether there is anything to cut off at all.
struct OrderOfCuts {
  bool end_first, cuts_begin, cuts_end;
};

/// The rule: the first cut leaves a part of length 1/2 or more, [0, b] if b >= 1/2 and [a, 1] otherwise. The place
/// of the second cut is a quotient by that length: no divisor is small, wherever a <= b lie. Knots are exact numbers
/// with an order.
template <typename Knot>
bool cuts_end_first(const Knot& b) {
  return !(b + b < Knot(1));
}
template <typename Knot>
OrderOfCuts order_of_cuts(const Knot& a, const Knot& b) {
  return {cuts_end_first(b), !(a == Knot(0)), !(b == Knot(1))};
}

/// Where the cuts that leave [a, b] are: the first one at a or b, the second one in units of what the first one leaves.
template <typename R>
struct CutPlaces {
  R begin, end;

  CutPlaces(const R& a, const R& b, const R& unit, bool end_first)
      : begin(end_first ? R(a / b) : a), end(end_first ? b : R((b - a) / (unit - a))) {}
};

/// Both cuts as blends. Blend: see de_casteljau_line.h.
template <typename Blend>
struct PartCuts {
  OrderOfCuts order;
  Blend begin, end;

  /// Replaces the coefficients on [0, 1] by those on [a, b].  @cost degree^2 blends or fewer
  template <typename R>
  void apply(R* first, std::size_t stride, int degree) const {
    if (order.cuts_end && order.end_first) keep_left(first, stride, degree, end);
    if (order.cuts_begin) keep_right(first, stride, degree, begin);
    if (order.cuts_end && !order.end_first) keep_left(first, stride, degree, end);
  }
};

}  // namespace veritope::internal
