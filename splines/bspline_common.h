// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline_common.h: two B-splines on the same knots.
#pragma once
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "splines/bspline.h"
#include "splines/bspline_degree.h"
#include "splines/bspline_domain.h"
#include "splines/knot_insertion.h"

namespace veritope {

/// Both maps, clamped, with the greater degree along each axis and each knot as often as the map requires that needs it
/// more often. Polynomial maps are equal iff their coefficients then are equal; rational maps are equal if their
/// coefficients then are equal up to one factor.
/// @error kBadArgument, with the axis and a parameter, if the domains differ: see with_domain.
template <Ring R, std::size_t N>
Result<std::pair<BSpline<R, N>, BSpline<R, N>>> to_common_axes(BSpline<R, N> a, BSpline<R, N> b) {
  for (std::size_t axis = 0; axis < N; ++axis) {
    const auto &x = a.axis(axis), &y = b.axis(axis);
    for (const auto& [u, v] :
         {std::pair(x.domain_begin(), y.domain_begin()), std::pair(x.domain_end(), y.domain_end())})
      if (!(u == v))
        return internal::axis_error(Code::kBadArgument, axis,
                                    "the domain of one map ends at " + internal::knot_text(u) +
                                        ", that of the other at " + internal::knot_text(v));
    const int degree = std::max(x.degree, y.degree);
    const int by_a = degree - x.degree, by_b = degree - y.degree;
    a = elevate(clamped(a, axis), axis, by_a);
    b = elevate(clamped(b, axis), axis, by_b);
    const auto &s = a.axis(axis).knots, &t = b.axis(axis).knots;
    std::vector<typename RingNumbers<R>::Knot> for_a, for_b;
    std::set_difference(t.begin(), t.end(), s.begin(), s.end(), std::back_inserter(for_a));
    std::set_difference(s.begin(), s.end(), t.begin(), t.end(), std::back_inserter(for_b));
    a = refine(a, axis, for_a);
    b = refine(b, axis, for_b);
  }
  return std::pair(std::move(a), std::move(b));
}

}  // namespace veritope
