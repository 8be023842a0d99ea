// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/piece_bounds.h: the only place of this folder where floating-point operations decide.
// Bounds: docs/bounds/piece_net.md, recomputed in exact rationals by tests/solids/piece_net_bound_test.cc.
//
// A net holds doubles m_i and one number `error` for each component; the exact coefficients lie within
// `error` of them. Each function below either turns such numbers into an answer that is right for every
// choice of exact coefficients, or gives no answer; then integers decide (exact_piece.h, exact_winding.h), or the
// question stays open. What other files of the folder do with doubles is a search, or it is interval arithmetic
// (forest_builder.cc, patch_volume.cc), which needs no constant.
//
// Formulas are templates, because the bound test runs the same lines on numbers that count roundings.
// Needs: any rounding mode (roots are made while this thread rounds upward), gradual underflow, no contraction.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

namespace veritope::internal {

/// u: every rounded operation errs by at most this times its exact result, in every rounding mode.
inline constexpr double kNetUnit = 0x1p-52;
/// More than all underflows of one decision.
inline constexpr double kNetTiny = 0x1p-1000;
/// Pays for products of errors, and for the roundings of the bounds themselves.
inline constexpr double kNetSlack = 1 + 0x1p-40;

// ---- 1. halving

template <typename Number>
Number average(const Number& a, const Number& b) {
  return 0.5 * (a + b);
}
/// Claim: if every coefficient of a net is known up to `error` and none exceeds `size`, then a coefficient
/// that is the result of at most `steps` averages, one after the other, is known up to this. An average errs
/// by at most u size. REQUIRES steps <= 2^10.
inline double error_after_halving(double error, double size, int steps) {
  return (error + steps * (kNetUnit * size) + kNetTiny) * kNetSlack;
}

// ---- 2. the sign of n·(S - c)

/// g_c = G0 + G1 x0 + G2 x1 + G3 x2 with x = c - origin.
template <typename Number>
Number side_value(const Number& g0, const Number& g1, const Number& g2, const Number& g3,
                  const std::array<Number, 3>& x) {
  return g0 + (g1 * x[0] + g2 * x[1] + g3 * x[2]);
}
/// n0 + |x0| n1 + |x1| n2 + |x2| n3: of the components' errors, and of their magnitudes.
template <typename Number>
Number side_sum(const Number& n0, const Number& n1, const Number& n2, const Number& n3,
                const std::array<Number, 3>& x) {
  using std::abs;
  return n0 + abs(x[0]) * n1 + abs(x[1]) * n2 + abs(x[2]) * n3;
}
inline constexpr double kSideRel = 0x1.4p-50;  // 5 u

/// Claim: side_value of the nets and of x differs from that of the exact coefficients and the exact c -
/// origin by at most this.
inline double side_bound(double error, double magnitude) {
  return (error + kSideRel * magnitude) * kNetSlack + kNetTiny;
}

enum class CommonSign {
  kPositive,
  kNegative,
  kMixed,  ///< one is surely negative, another surely positive
  kUnknown
};
/// The sign of exact numbers that lie within `bound` of numbers between lo and hi, where both ends are taken.
inline CommonSign common_sign(double lo, double hi, double bound) {
  if (lo > bound) return CommonSign::kPositive;
  if (hi < -bound) return CommonSign::kNegative;
  return lo < -bound && hi > bound ? CommonSign::kMixed : CommonSign::kUnknown;
}

// ---- 3. hulls

/// Both ends of x -+ error, before outward rounding.
template <typename Number>
std::array<Number, 2> hull_ends(const Number& x, const Number& error) {
  return {x - error, x + error};
}
/// Both ends of (x -+ error) / (w -+ w_error), before outward rounding. REQUIRES w - w_error > 0.
template <typename Number>
std::array<Number, 2> hull_ends(const Number& x, const Number& error, const Number& w,
                                const Number& w_error) {
  const Number w_lo = w - w_error, w_hi = w + w_error, a = x - error, b = x + error;
  return {a / (a < 0 ? w_lo : w_hi), b / (b < 0 ? w_hi : w_lo)};
}
inline constexpr double kHullRel = 0x1p-50;            // 4 u, of a polynomial piece
inline constexpr double kRationalHullRel = 0x1.4p-50;  // 5 u
inline constexpr double kHullOriginRel = 0x1p-50;      // 4 u

/// Claim: origin + lo - slack and origin + hi + slack, as computed, lie outside of the exact sums. lo, hi:
/// the least and the greatest of the hull_ends.
inline double hull_slack(double lo, double hi, double origin, bool is_rational) {
  const double rel = is_rational ? kRationalHullRel : kHullRel;
  const double size = std::max(std::abs(lo), std::abs(hi));
  return (rel * size + kHullOriginRel * std::abs(origin)) * kNetSlack + kNetTiny;
}

// ---- 4. crossing numbers

/// A coordinate of a homogeneous control point relative to the centre, c = centre - origin.
template <typename Number>
Number relative_to_centre(const Number& m, const Number& w, const Number& c) {
  return m - w * c;
}
/// A coordinate of the projection along d, times d_k; p_k is the coordinate along the axis where |d| is greatest.
template <typename Number>
Number projected(const Number& p, const Number& p_k, const Number& d, const Number& d_k) {
  return p * d_k - p_k * d;
}
/// The projection turned: both coordinates.
template <typename Number>
std::array<Number, 2> turned(const Number& t0, const Number& t1, const Number& x, const Number& y) {
  return {t0 * x - t1 * y, t1 * x + t0 * y};
}
inline constexpr double kProjectedRel = 0x1.8p-50;  // 6 u, for the turn (1, 0)
inline constexpr double kTurnedRel = 0x1p-49;       // 8 u

/// Claim: the turned coordinates differ from the exact ones by at most this.
/// error: at least that of m and |c| that of w, on every axis; size: at least |m| + |w c|; reach: at least every |d|.
inline double crossing_bound(double error, double size, double reach,
                             const std::array<double, 2>& turn) {
  const double rel = turn[1] == 0 ? kProjectedRel : kTurnedRel;
  const double length = std::abs(turn[0]) + std::abs(turn[1]);
  return 2 * length * reach * (error + rel * size + kNetTiny) * kNetSlack + kNetTiny;
}

/// Whether a number that is known up to `bound` is positive, or negative.
inline bool is_surely_positive(double v, double bound) { return v > bound; }
inline bool is_surely_negative(double v, double bound) { return v < -bound; }

}  // namespace veritope::internal
