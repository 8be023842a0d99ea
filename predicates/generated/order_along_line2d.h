// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/order_along_line2d.h: which of p and q comes later along the line from a to b?
// Made by tools/generate_predicates.py from predicates/generated/order_along_line2d.formula: do not edit.
// Bound: docs/bounds/order_along_line2d.md.
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

/// The exact sign of (b - a) . (p - q): positive iff p comes after q in the direction from a to b,
/// zero iff the line's normal plane through p contains q. The points need not lie on the line:
/// their projections are compared. Laws:
///   (1) swapping p and q negates it;
///   (2) swapping a and b negates it;
///   (3) it does not change when a and b move by the same vector exactly;
///   (4) it does not change when p and q move by the same vector exactly;
///   (5) it does not change when all coordinates are scaled by one power of two.
/// Degenerate input: a = b gives zero.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 2 in binary64 where the filter decides
Sign order_along_line2d(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q,
      TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (3u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/order_along_line2d.md, and again in
///          tests/predicates/generated/order_along_line2d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 order_along_line2d_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) noexcept;

namespace internal {
inline constexpr double kOrderAlongLine2dRel = 0x1.8000000000007p-52;

Sign3 order_along_line2d_lattice(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) noexcept;
Sign3 order_along_line2d_interval(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) noexcept;
Sign order_along_line2d_exact(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) noexcept;
Sign order_along_line2d_after_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto order_along_line2d_det(
    const auto& ux, const auto& uy, const auto& vx, const auto& vy) {
  return ux * vx + uy * vy;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto order_along_line2d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& vx, const auto& vy) {
  return abs(ux * vx) + abs(uy * vy);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T order_along_line2d_of(const std::array<T, 8>& v) {
  return order_along_line2d_det(v[2] - v[0], v[3] - v[1], v[4] - v[6], v[5] - v[7]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double order_along_line2d_error(
    FilterReal ux, FilterReal uy, FilterReal vx, FilterReal vy, double floor_) {
  const FilterReal magnitude_ = formulas::order_along_line2d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, ux, uy, vx, vy);
  return FilterReal(kOrderAlongLine2dRel) * magnitude_ + FilterReal(floor_);
}
}  // namespace internal

inline Sign3 order_along_line2d_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) noexcept {
  const FilterReal ux = FilterReal(b.x) - FilterReal(a.x);
  const FilterReal uy = FilterReal(b.y) - FilterReal(a.y);
  const FilterReal vx = FilterReal(p.x) - FilterReal(q.x);
  const FilterReal vy = FilterReal(p.y) - FilterReal(q.y);
  const FilterReal det_ = formulas::order_along_line2d_det(ux, uy, vx, vy);
  return sign_beyond(det_, [&](double floor_) {
    return internal::order_along_line2d_error(ux, uy, vx, vy, floor_);
  });
}

inline Sign order_along_line2d(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return order_along_line2d_filter(a, b, p, q); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::order_along_line2d_after_filter(a, b, p, q, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
