// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/mp_restriction_internal.h: polynomials on boxes over intervals of many bits.
#pragma once
#include <vector>

#include "interval/exact_box.h"
#include "interval/mp_interval.h"
#include "splines/grid.h"
#include "splines/restriction.h"

namespace veritope::internal {

/// Replaces Bernstein coefficients on [0,1]^N by those on a box, which may extend beyond [0,1]^N.
template <std::size_t N>
void restrict_to(std::vector<MpInterval>& values, const Grid<N>& grid, const ExactBox<N>& box,
                 int precision) {
  const auto cut_at = [precision](const Rational& t) {
    return AffineBlend<MpInterval>{MpInterval(Rational(1) - t, precision),
                                   MpInterval(t, precision)};
  };
  for (std::size_t axis = 0; axis < N; ++axis) {
    const Rational& a = box[axis].lo;
    const Rational& b = box[axis].hi;
    const OrderOfCuts order = order_of_cuts(a, b);
    const CutPlaces<Rational> places(a, b, Rational(1), order.end_first);
    const PartCuts<AffineBlend<MpInterval>> cuts{order, cut_at(places.begin), cut_at(places.end)};
    const std::size_t stride = grid.stride(axis);
    grid.for_each_line(axis, [&](std::size_t first) {
      cuts.apply(values.data() + first, stride, static_cast<int>(grid.size[axis]) - 1);
    });
  }
}

}  // namespace veritope::internal
