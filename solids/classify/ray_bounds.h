// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/ray_bounds.h: where floating-point operations decide about patches and points. Bounds:
// docs/bounds/ray_net.md, recomputed in exact rationals by tests/solids/ray_net_bound_test.cc. Halving, its bound and
// the slack are those of solids/pieces/piece_bounds.h.
//
// A net holds doubles and one number `error` for each coordinate; the exact coefficients lie within it. Either an
// answer is right for every choice of them, or integers have to decide. Formulas are templates, because the bound
// test runs the same lines on numbers that count roundings.
#pragma once
#include <array>
#include <cmath>

#include "solids/pieces/piece_bounds.h"

namespace veritope::internal {

// ---- 1. coordinates relative to a point

inline constexpr double kRelativeRel = 0x1p-50;  // 4 u

/// Claim: if m, w and c are the exact numbers rounded, relative_to_centre(m, w, c) differs from the exact result by at
/// most this.
/// size >= |m| + |w c|.
inline double relative_bound(double size) { return kRelativeRel * size * kNetSlack + kNetTiny; }

// ---- 2. the side of a plane through the point

/// n·p.
template <typename Number>
Number plane_value(const std::array<Number, 3>& n, const Number& x, const Number& y,
                   const Number& z) {
  return n[0] * x + (n[1] * y + n[2] * z);
}
inline constexpr double kPlaneRel = 0x1.8p-51;  // 3 u

/// Claim: plane_value of coordinates that are known up to `error` differs from the exact n·p by at most this; the
/// normal is exact. error and size are |n0| e0 + |n1| e1 + |n2| e2, added as plane_value adds, of the coordinates'
/// errors and of their greatest absolute values.
inline double plane_bound(double error, double size) {
  return (error + kPlaneRel * size) * kNetSlack + kNetTiny;
}

// ---- 3. projected curves, turned

inline constexpr double kTurnRel = 0x1p-51;  // 2 u

/// Claim: both coordinates of turned(), from coordinates that are known up to `error` and at most `size`, differ from
/// the exact ones by at most this.
inline double turn_bound(double error, double size, const std::array<double, 2>& turn) {
  const double length = std::abs(turn[0]) + std::abs(turn[1]);
  return length * (error + kTurnRel * size) * kNetSlack + kNetTiny;
}

}  // namespace veritope::internal
