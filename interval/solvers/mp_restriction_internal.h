// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/mp_restriction_internal.h: polynomials on boxes over intervals of many bits.
#pragma once
#include <vector>

#include "interval/exact_box.h"
#include "interval/mp_interval.h"
#include "splines/de_casteljau_line.h"
#include "splines/grid.h"

namespace veritope::internal {

template <std::size_t N>
struct LineCut {
  const Grid<N>& grid;
  std::size_t axis;
  int precision;

  // Keeps [0, at] or [at, 1].
  void keep(std::vector<MpInterval>& values, const Rational& at, bool is_left) const {
    const AffineBlend<MpInterval> blend{MpInterval(Rational(1) - at, precision),
                                        MpInterval(at, precision)};
    const std::size_t stride = grid.stride(axis);
    const int degree = static_cast<int>(grid.size[axis]) - 1;
    grid.for_each_line(axis, [&](std::size_t first) {
      MpInterval* const line = values.data() + first;
      is_left ? keep_left(line, stride, degree, blend) : keep_right(line, stride, degree, blend);
    });
  }
};

// The Bernstein coefficients on a box of those on [0,1]^N. Cut so that no divisor is small.
template <std::size_t N>
void restrict_to(std::vector<MpInterval>& values, const Grid<N>& grid, const ExactBox<N>& box,
                 int precision) {
  for (std::size_t axis = 0; axis < N; ++axis) {
    const Rational& a = box[axis].lo;
    const Rational& b = box[axis].hi;
    const LineCut<N> cut{grid, axis, precision};
    if (a * Rational(2) < Rational(1)) {
      if (a.sign() != Sign::kZero) cut.keep(values, a, false);
      if (b != Rational(1)) cut.keep(values, (b - a) / (Rational(1) - a), true);
    } else {
      if (b != Rational(1)) cut.keep(values, b, true);
      cut.keep(values, a / b, false);
    }
  }
}

}  // namespace veritope::internal
