// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/power_circle.h: is the weighted point d in conflict with the circle that is orthogonal to those of a, b, c?
// Made by tools/generate_predicates.py from predicates/generated/power_circle.formula: do not edit.
// Source: [ES96].
// Bound: docs/bounds/power_circle.md.
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

/// The exact sign of the lifted determinant, with |p|^2 - w in the place of |p|^2; a weight is a
/// squared radius, and may be negative. If orient2d(a, b, c) > 0: positive iff the power of d to
/// the circle that is orthogonal to a, b, c is negative, so that d belongs into the triangulation
/// in the place of the triangle, zero iff d's circle is orthogonal, too. With equal weights it is
/// in_circle. Laws:
///   (1) swapping a and b, wa and wb negates it;
///   (2) swapping b and c, wb and wc negates it;
///   (3) swapping c and d, wc and wd negates it;
///   (4) it does not change when all points move by the same vector exactly;
///   (5) it does not change when lengths are scaled by a power of two and weights by its square.
/// Degenerate input: zero for two equal points with equal weights; if a, b, c are collinear, the
/// sign orders them and d along the lifted line.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 4 in binary64 where the filter decides
Sign power_circle(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd, TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (11u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/power_circle.md, and again in
///          tests/predicates/generated/power_circle_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 power_circle_filter(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) noexcept;

namespace internal {
inline constexpr double kPowerCircleRel = 0x1.600000000000ep-50;
inline constexpr double kPowerCircleEta = 0x1p-900;

Sign3 power_circle_lattice(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) noexcept;
Sign3 power_circle_interval(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) noexcept;
Sign power_circle_exact(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) noexcept;
Sign power_circle_after_filter(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto power_circle_det(
    const auto& px, const auto& py, const auto& qx, const auto& qy, const auto& rx, const auto& ry,
    const auto& pw, const auto& qw, const auto& rw) {
  const auto p_lift = (sqr(px) + sqr(py)) - pw;
  const auto q_lift = (sqr(qx) + sqr(qy)) - qw;
  const auto r_lift = (sqr(rx) + sqr(ry)) - rw;
  return (p_lift * (qx * ry - qy * rx) + q_lift * (rx * py - ry * px)) +
      r_lift * (px * qy - py * qx);
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto power_circle_magnitude(
    [[maybe_unused]] Abs abs, const auto& px, const auto& py, const auto& qx, const auto& qy,
    const auto& rx, const auto& ry, const auto& pw, const auto& qw, const auto& rw) {
  const auto p_lift_ = (sqr(px) + sqr(py)) + abs(pw);
  const auto q_lift_ = (sqr(qx) + sqr(qy)) + abs(qw);
  const auto r_lift_ = (sqr(rx) + sqr(ry)) + abs(rw);
  return (p_lift_ * (abs(qx * ry) + abs(qy * rx)) + q_lift_ * (abs(rx * py) +
      abs(ry * px))) + r_lift_ * (abs(px * qy) + abs(py * qx));
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T power_circle_of(const std::array<T, 12>& v) {
  return power_circle_det(
      v[0] - v[9], v[1] - v[10], v[3] - v[9], v[4] - v[10], v[6] - v[9], v[7] - v[10], v[2] - v[11],
      v[5] - v[11], v[8] - v[11]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double power_circle_error(
    FilterReal px, FilterReal py, FilterReal qx, FilterReal qy, FilterReal rx, FilterReal ry,
    FilterReal pw, FilterReal qw, FilterReal rw, double floor_) {
  const FilterReal magnitude_ = formulas::power_circle_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, px, py, qx, qy,
      rx, ry, pw, qw, rw);
  const FilterReal size_ = largest_of(px, py, qx, qy, rx, ry, pw, qw, rw);
  return FilterReal(kPowerCircleRel) * magnitude_ +
         (FilterReal(kPowerCircleEta) * power_of<2>(size_) + FilterReal(floor_));
}
}  // namespace internal

inline Sign3 power_circle_filter(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) noexcept {
  const FilterReal px = FilterReal(a.x) - FilterReal(d.x);
  const FilterReal py = FilterReal(a.y) - FilterReal(d.y);
  const FilterReal qx = FilterReal(b.x) - FilterReal(d.x);
  const FilterReal qy = FilterReal(b.y) - FilterReal(d.y);
  const FilterReal rx = FilterReal(c.x) - FilterReal(d.x);
  const FilterReal ry = FilterReal(c.y) - FilterReal(d.y);
  const FilterReal pw = FilterReal(wa) - FilterReal(wd);
  const FilterReal qw = FilterReal(wb) - FilterReal(wd);
  const FilterReal rw = FilterReal(wc) - FilterReal(wd);
  const FilterReal det_ = formulas::power_circle_det(px, py, qx, qy, rx, ry, pw, qw, rw);
  return sign_beyond(det_, [&](double floor_) {
    return internal::power_circle_error(px, py, qx, qy, rx, ry, pw, qw, rw, floor_);
  });
}

inline Sign power_circle(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return power_circle_filter(a, wa, b, wb, c, wc, d, wd); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::power_circle_after_filter(a, wa, b, wb, c, wc, d, wd, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
