// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/piece_net_internal.h: de Casteljau's halving of nets of doubles, and the bound of its errors.
// Bound: docs/bounds/piece_net.md.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "solids/pieces/surface_form.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {

/// Every rounded operation errs by at most this times its result, in any rounding mode, beside kNetTiny.
inline constexpr double kNetUnit = 0x1p-52;
inline constexpr double kNetTiny = 0x1p-1000;

/// Claim: if every coefficient of a net is known up to `error` and none exceeds `size`, those of a half of it are known up to this.
/// A step (a + b) / 2 errs by at most kNetUnit * size; a coefficient of the half is the result of at most `degree` steps one after the other.
inline double error_after_halving(double error, double size, int degree) {
  return (error + degree * (kNetUnit * size) + kNetTiny) * (1 + 0x1p-40);
}

/// The blend of nets of doubles. A power of two times a sum: one rounded operation unless the result is subnormal.
inline constexpr HalfBlend<double> kHalves{0.5};

/// The four children of a net of one component (children (0,0), (0,1), (1,0), (1,1) of a tensor).
void quarter_tensor(const FormShape& shape, const double* net, double* const children[4]);
/// Children (c0, m2, m1), (m2, c1, m0), (m1, m0, c2), (m0, m1, m2): only averages are taken.
void quarter_triangle(int degree, const double* net, double* const children[4]);
/// The greatest number of averages that follow each other in a coefficient of a child.
inline int quarter_depth(const FormShape& shape) {
  return shape.is_triangle ? 3 * shape.p : shape.p + shape.q;
}

}  // namespace veritope::internal
