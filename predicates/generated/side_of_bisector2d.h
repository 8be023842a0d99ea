// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/side_of_bisector2d.h: on which side of the bisector of a and b does p lie?
// Made by tools/generate_predicates.py from predicates/generated/side_of_bisector2d.formula: do not edit.
// Bound: docs/bounds/side_of_bisector2d.md.
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

/// The exact sign of |b - p|^2 - |a - p|^2: positive iff p lies on the side of a, zero iff on the
/// bisector; side_of_bisector2d(a, b, p) = -compare_distance2d(p, a, b), with the arguments in the
/// order of a side: the separating pair first, the point last. Laws:
///   (1) swapping a and b negates it;
///   (2) it does not change when all points move by the same vector exactly;
///   (3) it does not change when all coordinates are scaled by one power of two.
/// Degenerate input: a = b gives zero: there is no bisector.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 2 in binary64 where the filter decides
Sign side_of_bisector2d(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (4u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/side_of_bisector2d.md, and again in
///          tests/predicates/generated/side_of_bisector2d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 side_of_bisector2d_filter(const Vec2d& a, const Vec2d& b, const Vec2d& p) noexcept;

namespace internal {
inline constexpr double kSideOfBisector2dRel = 0x1.0000000000005p-51;

Sign3 side_of_bisector2d_lattice(const Vec2d& a, const Vec2d& b, const Vec2d& p) noexcept;
Sign3 side_of_bisector2d_interval(const Vec2d& a, const Vec2d& b, const Vec2d& p) noexcept;
Sign side_of_bisector2d_exact(const Vec2d& a, const Vec2d& b, const Vec2d& p) noexcept;
Sign side_of_bisector2d_after_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto side_of_bisector2d_det(
    const auto& ux, const auto& uy, const auto& vx, const auto& vy, const auto& wx,
    const auto& wy) {
  const auto sumx = vx + wx;
  const auto sumy = vy + wy;
  return ux * sumx + uy * sumy;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto side_of_bisector2d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& vx, const auto& vy,
    const auto& wx, const auto& wy) {
  const auto sumx_ = abs(vx) + abs(wx);
  const auto sumy_ = abs(vy) + abs(wy);
  return abs(ux) * sumx_ + abs(uy) * sumy_;
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T side_of_bisector2d_of(const std::array<T, 6>& v) {
  return side_of_bisector2d_det(
      v[2] - v[0], v[3] - v[1], v[0] - v[4], v[1] - v[5], v[2] - v[4], v[3] - v[5]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double side_of_bisector2d_error(
    FilterReal ux, FilterReal uy, FilterReal vx, FilterReal vy, FilterReal wx, FilterReal wy,
    double floor_) {
  const FilterReal magnitude_ = formulas::side_of_bisector2d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, ux, uy, vx, vy,
      wx, wy);
  return FilterReal(kSideOfBisector2dRel) * magnitude_ + FilterReal(floor_);
}
}  // namespace internal

inline Sign3 side_of_bisector2d_filter(const Vec2d& a, const Vec2d& b, const Vec2d& p) noexcept {
  const FilterReal ux = FilterReal(b.x) - FilterReal(a.x);
  const FilterReal uy = FilterReal(b.y) - FilterReal(a.y);
  const FilterReal vx = FilterReal(a.x) - FilterReal(p.x);
  const FilterReal vy = FilterReal(a.y) - FilterReal(p.y);
  const FilterReal wx = FilterReal(b.x) - FilterReal(p.x);
  const FilterReal wy = FilterReal(b.y) - FilterReal(p.y);
  const FilterReal det_ = formulas::side_of_bisector2d_det(ux, uy, vx, vy, wx, wy);
  return sign_beyond(det_, [&](double floor_) {
    return internal::side_of_bisector2d_error(ux, uy, vx, vy, wx, wy, floor_);
  });
}

inline Sign side_of_bisector2d(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return side_of_bisector2d_filter(a, b, p); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::side_of_bisector2d_after_filter(a, b, p, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
