// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/power_edge2d.h: is the weighted point d in conflict with the smallest circle that is orthogonal to those of a and b?
// Made by tools/generate_predicates.py from predicates/generated/power_edge2d.formula: do not edit.
// Source: [ES96].
// Bound: docs/bounds/power_edge2d.md.
// clang-format off
#pragma once
#include <array>
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/generated/scaling.h"
#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/filter.h"

VT_PRECISE_BEGIN
namespace veritope {

/// The exact sign of |b - a|^2 times minus the power of d to the smallest of the circles that are
/// orthogonal to those of a and b, its centre on the line ab; a weight is a squared radius, and may
/// be negative: positive iff d is in conflict with it, zero iff orthogonal. With equal weights:
/// positive iff d lies inside the circle with the diameter ab. For collinear a, b, d it is the test
/// of regular triangulations on their line, whatever the order of a and b. Laws:
///   (1) swapping a and b, wa and wb does not change it;
///   (2) it does not change when all points move by the same vector exactly;
///   (3) it does not change when lengths are scaled by a power of two and weights by its square.
/// Degenerate input: a = b gives zero.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 4 in binary64 where the filter decides
Sign power_edge2d(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& d, double wd,
      TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (9u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/power_edge2d.md, and again in
///          tests/predicates/generated/power_edge2d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 power_edge2d_filter(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& d, double wd) noexcept;

namespace internal {
inline constexpr double kPowerEdge2dRel = 0x1.200000000000ap-50;
inline constexpr double kPowerEdge2dEta = 0x1p-900;

Sign3 power_edge2d_lattice(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& d, double wd) noexcept;
Sign3 power_edge2d_interval(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& d, double wd) noexcept;
Sign power_edge2d_exact(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& d, double wd) noexcept;
Sign power_edge2d_after_filter(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& d, double wd,
      TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto power_edge2d_det(
    const auto& px, const auto& py, const auto& qx, const auto& qy, const auto& ux, const auto& uy,
    const auto& da, const auto& db) {
  return (da * (qx * ux + qy * uy) - db * (px * ux + py * uy)) - (px * qx +
      py * qy) * (sqr(ux) + sqr(uy));
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto power_edge2d_magnitude(
    [[maybe_unused]] Abs abs, const auto& px, const auto& py, const auto& qx, const auto& qy,
    const auto& ux, const auto& uy, const auto& da, const auto& db) {
  return (abs(da) * (abs(qx * ux) + abs(qy * uy)) + abs(db) * (abs(px * ux) +
      abs(py * uy))) + (abs(px * qx) + abs(py * qy)) * (sqr(ux) + sqr(uy));
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T power_edge2d_of(const std::array<T, 9>& v) {
  return power_edge2d_det(
      v[0] - v[6], v[1] - v[7], v[3] - v[6], v[4] - v[7], v[3] - v[0], v[4] - v[1], v[8] - v[2],
      v[8] - v[5]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double power_edge2d_error(
    FilterReal px, FilterReal py, FilterReal qx, FilterReal qy, FilterReal ux, FilterReal uy,
    FilterReal da, FilterReal db, double floor_) {
  const FilterReal magnitude_ = formulas::power_edge2d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, px, py, qx, qy,
      ux, uy, da, db);
  const FilterReal size_ = largest_of(px, py, qx, qy, ux, uy, da, db);
  return FilterReal(kPowerEdge2dRel) * magnitude_ +
         (FilterReal(kPowerEdge2dEta) * power_of<2>(size_) + FilterReal(floor_));
}
}  // namespace internal

inline Sign3 power_edge2d_filter(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& d, double wd) noexcept {
  const FilterReal px = FilterReal(a.x) - FilterReal(d.x);
  const FilterReal py = FilterReal(a.y) - FilterReal(d.y);
  const FilterReal qx = FilterReal(b.x) - FilterReal(d.x);
  const FilterReal qy = FilterReal(b.y) - FilterReal(d.y);
  const FilterReal ux = FilterReal(b.x) - FilterReal(a.x);
  const FilterReal uy = FilterReal(b.y) - FilterReal(a.y);
  const FilterReal da = FilterReal(wd) - FilterReal(wa);
  const FilterReal db = FilterReal(wd) - FilterReal(wb);
  const FilterReal det_ = formulas::power_edge2d_det(px, py, qx, qy, ux, uy, da, db);
  return sign_beyond(det_, [&](double floor_) {
    return internal::power_edge2d_error(px, py, qx, qy, ux, uy, da, db, floor_);
  });
}

inline Sign power_edge2d(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& d, double wd,
      TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return power_edge2d_filter(a, wa, b, wb, d, wd); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::power_edge2d_after_filter(a, wa, b, wb, d, wd, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
