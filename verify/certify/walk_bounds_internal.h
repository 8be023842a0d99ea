// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/walk_bounds_internal.h: the parameter, in doubles, at which a segment passes a coordinate. The only
// rounding bound of this folder: docs/bounds/decisions.md lists what else it does with doubles. Recomputed in
// tests/certify/walk_bound_test.cc.
#pragma once
#include <cmath>

namespace veritope::internal {

/// t with x = a + t (b - a). REQUIRES a != b.
template <typename Number>
Number segment_parameter(const Number& x, const Number& a, const Number& b) {
  return (x - a) / (b - a);
}
/// 5 u with u = 2^-52, which bounds a rounding in every mode: two differences, a quotient, and the two differences
/// below.
inline constexpr double kParameterRel = 0x1.4p-50 * (1 + 0x1p-40), kParameterTiny = 0x1p-1000;
/// Claim: the exact parameter lies between these two, if t is the computed one.
inline double parameter_below(double t) { return t - kParameterRel * std::abs(t) - kParameterTiny; }
inline double parameter_above(double t) { return t + kParameterRel * std::abs(t) + kParameterTiny; }

}  // namespace veritope::internal
