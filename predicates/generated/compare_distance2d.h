// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/compare_distance2d.h: which of a and b is farther from p?
// Made by tools/generate_predicates.py from predicates/generated/compare_distance2d.formula: do not edit.
// Bound: docs/bounds/compare_distance2d.md.
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

/// The exact sign of |a - p|^2 - |b - p|^2: positive iff a is farther from p than b, zero iff both
/// are equally far. Laws:
///   (1) swapping a and b negates it;
///   (2) it does not change when all points move by the same vector exactly;
///   (3) it does not change when all coordinates are scaled by one power of two.
/// Degenerate input: a = b gives zero.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 2 in binary64 where the filter decides
Sign compare_distance2d(
      const Vec2d& p, const Vec2d& a, const Vec2d& b, TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (4u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/compare_distance2d.md, and again in
///          tests/predicates/generated/compare_distance2d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 compare_distance2d_filter(const Vec2d& p, const Vec2d& a, const Vec2d& b) noexcept;

namespace internal {
inline constexpr double kCompareDistance2dRel = 0x1.0000000000005p-51;

Sign3 compare_distance2d_lattice(const Vec2d& p, const Vec2d& a, const Vec2d& b) noexcept;
Sign3 compare_distance2d_interval(const Vec2d& p, const Vec2d& a, const Vec2d& b) noexcept;
Sign compare_distance2d_exact(const Vec2d& p, const Vec2d& a, const Vec2d& b) noexcept;
Sign compare_distance2d_after_filter(
      const Vec2d& p, const Vec2d& a, const Vec2d& b, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto compare_distance2d_det(
    const auto& ux, const auto& uy, const auto& vx, const auto& vy, const auto& wx,
    const auto& wy) {
  const auto sumx = vx + wx;
  const auto sumy = vy + wy;
  return ux * sumx + uy * sumy;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto compare_distance2d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& vx, const auto& vy,
    const auto& wx, const auto& wy) {
  const auto sumx_ = abs(vx) + abs(wx);
  const auto sumy_ = abs(vy) + abs(wy);
  return abs(ux) * sumx_ + abs(uy) * sumy_;
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T compare_distance2d_of(const std::array<T, 6>& v) {
  return compare_distance2d_det(
      v[2] - v[4], v[3] - v[5], v[2] - v[0], v[3] - v[1], v[4] - v[0], v[5] - v[1]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double compare_distance2d_error(
    FilterReal ux, FilterReal uy, FilterReal vx, FilterReal vy, FilterReal wx, FilterReal wy,
    double floor_) {
  const FilterReal magnitude_ = formulas::compare_distance2d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, ux, uy, vx, vy,
      wx, wy);
  return FilterReal(kCompareDistance2dRel) * magnitude_ + FilterReal(floor_);
}
}  // namespace internal

inline Sign3 compare_distance2d_filter(const Vec2d& p, const Vec2d& a, const Vec2d& b) noexcept {
  const FilterReal ux = FilterReal(a.x) - FilterReal(b.x);
  const FilterReal uy = FilterReal(a.y) - FilterReal(b.y);
  const FilterReal vx = FilterReal(a.x) - FilterReal(p.x);
  const FilterReal vy = FilterReal(a.y) - FilterReal(p.y);
  const FilterReal wx = FilterReal(b.x) - FilterReal(p.x);
  const FilterReal wy = FilterReal(b.y) - FilterReal(p.y);
  const FilterReal det_ = formulas::compare_distance2d_det(ux, uy, vx, vy, wx, wy);
  return sign_beyond(det_, [&](double floor_) {
    return internal::compare_distance2d_error(ux, uy, vx, vy, wx, wy, floor_);
  });
}

inline Sign compare_distance2d(
      const Vec2d& p, const Vec2d& a, const Vec2d& b, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return compare_distance2d_filter(p, a, b); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::compare_distance2d_after_filter(p, a, b, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
