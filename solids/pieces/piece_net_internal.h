// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/piece_net_internal.h: de Casteljau's halving of nets. Bound of its errors:
// error_after_halving in piece_bounds.h.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "solids/pieces/piece_bounds.h"
#include "solids/pieces/surface_form.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {

/// The blend of nets, for the loops of splines/de_casteljau_line.h.
struct AverageBlend {
  template <typename Number>
  void into_first(Number& a, const Number& b) const {
    a = average(a, b);
  }
  template <typename Number>
  void into_second(const Number& a, Number& b) const {
    b = average(a, b);
  }
};
inline constexpr AverageBlend kHalves;

/// The four children of a net of one component (children (0,0), (0,1), (1,0), (1,1) of a tensor).
/// Bodies: piece_net_quarters_internal.h.
template <typename Number>
void quarter_tensor(const FormShape& shape, const Number* net, Number* const children[4]);
/// Children (c0, m2, m1), (m2, c1, m0), (m1, m0, c2), (m0, m1, m2): only averages are computed.
template <typename Number>
void quarter_triangle(int degree, const Number* net, Number* const children[4]);
extern template void quarter_tensor(const FormShape&, const double*, double* const[4]);
extern template void quarter_triangle(int, const double*, double* const[4]);
/// The greatest number of averages that follow each other in a coefficient of a child. In a triangle, coefficient (j,
/// k) of a corner child takes j in the first halving and k in the second; in the middle child i for the arguments m0,
/// then j + k.
inline int quarter_depth(const FormShape& shape) {
  return shape.is_triangle ? shape.p : shape.p + shape.q;
}

}  // namespace veritope::internal
