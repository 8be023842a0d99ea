// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/compare_lengths2d.h: which of the segments ab and cd is longer?
// Made by tools/generate_predicates.py from predicates/generated/compare_lengths2d.formula: do not edit.
// Bound: docs/bounds/compare_lengths2d.md.
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

/// The exact sign of |b - a|^2 - |d - c|^2: positive iff ab is longer than cd, zero iff they are
/// equally long. Laws:
///   (1) swapping a and b does not change it;
///   (2) swapping a and c, b and d negates it;
///   (3) it does not change when a and b move by the same vector exactly;
///   (4) it does not change when c and d move by the same vector exactly;
///   (5) it does not change when all coordinates are scaled by one power of two.
/// Degenerate input: a segment of equal points has length zero.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 2 in binary64 where the filter decides
Sign compare_lengths2d(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d,
      TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (4u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/compare_lengths2d.md, and again in
///          tests/predicates/generated/compare_lengths2d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 compare_lengths2d_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;

namespace internal {
inline constexpr double kCompareLengths2dRel = 0x1.0000000000005p-51;

Sign3 compare_lengths2d_lattice(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;
Sign3 compare_lengths2d_interval(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;
Sign compare_lengths2d_exact(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;
Sign compare_lengths2d_after_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto compare_lengths2d_det(
    const auto& ux, const auto& uy, const auto& vx, const auto& vy) {
  return (sqr(ux) + sqr(uy)) - (sqr(vx) + sqr(vy));
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto compare_lengths2d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& vx, const auto& vy) {
  return (sqr(ux) + sqr(uy)) + (sqr(vx) + sqr(vy));
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T compare_lengths2d_of(const std::array<T, 8>& v) {
  return compare_lengths2d_det(v[2] - v[0], v[3] - v[1], v[6] - v[4], v[7] - v[5]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double compare_lengths2d_error(
    FilterReal ux, FilterReal uy, FilterReal vx, FilterReal vy, double floor_) {
  const FilterReal magnitude_ = formulas::compare_lengths2d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, ux, uy, vx, vy);
  return FilterReal(kCompareLengths2dRel) * magnitude_ + FilterReal(floor_);
}
}  // namespace internal

inline Sign3 compare_lengths2d_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept {
  const FilterReal ux = FilterReal(b.x) - FilterReal(a.x);
  const FilterReal uy = FilterReal(b.y) - FilterReal(a.y);
  const FilterReal vx = FilterReal(d.x) - FilterReal(c.x);
  const FilterReal vy = FilterReal(d.y) - FilterReal(c.y);
  const FilterReal det_ = formulas::compare_lengths2d_det(ux, uy, vx, vy);
  return sign_beyond(det_, [&](double floor_) {
    return internal::compare_lengths2d_error(ux, uy, vx, vy, floor_);
  });
}

inline Sign compare_lengths2d(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return compare_lengths2d_filter(a, b, c, d); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::compare_lengths2d_after_filter(a, b, c, d, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
