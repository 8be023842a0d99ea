// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/orient2d.h: on which side of the line from a to b does c lie?
// Source: [She97] bound A, with terms for underflow.  Bound: docs/bounds/orient2d.md.
#pragma once
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/binary64.h"
#include "robust/cascade.h"
#include "robust/filter.h"

namespace veritope {

/// The exact sign of (b - a) x (c - a), twice the signed area of a, b, c: positive iff they turn
/// counter-clockwise, orient2d((0,0), (1,0), (0,1)) = +1; zero iff they lie on one line. Laws:
///   (1) swapping two points negates it; a cyclic shift keeps it;
///   (2) it does not change when all points move by the same vector exactly, nor when one axis is
///       scaled by a power of two.
/// REQUIRES finite coordinates; all are allowed, the subnormal and the largest included.
Sign orient2d(const Vec2d& a, const Vec2d& b, const Vec2d& c, TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |left - right - exact| <= (3u + O(u^2)) S + underflow, S = |left| + |right|, u = 2^-53; S is
///          |left + right| where it matters.
/// Derived  docs/bounds/orient2d.md, and again in tests/predicates/orient2d_bound_test.cc.
/// Needs    round to nearest, gradual underflow, no contraction (robust/base/fp_guard.h).
Sign3 orient2d_filter(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept;

namespace internal {
inline constexpr double kOrient2dRel = 0x1.8000000000007p-52;

Sign3 orient2d_lattice(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept;
Sign3 orient2d_interval(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept;
Sign orient2d_exact(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept;
/// What remains after the filter and orient2d_zero_line.
Sign orient2d_off_axes(const Vec2d& a, const Vec2d& b, const Vec2d& c, TierCounts* tally) noexcept;
}  // namespace internal

// Bodies.

namespace internal {
inline double orient2d_error(const formulas::Orient2d<FilterReal>& f, double floor) {
  return kOrient2dRel * f.cancelling_magnitude([](double v) { return std::abs(v); }) + floor;
}
}  // namespace internal

inline Sign3 orient2d_filter(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept {
  const formulas::Orient2d<FilterReal> f(a.x, a.y, b.x, b.y, c.x, c.y);
  return sign_beyond(f.det(), [&](double floor) { return internal::orient2d_error(f, floor); });
}

namespace internal {
/// Zero if a column of the determinant is zero (the points lie on a line along an axis) or its first row is (a = b).
/// Both are frequent in models, and this costs less than a call. It compares bits, so that the floating-point
/// environment does not matter; 0 and -0 count as different, which leaves the answer to the next tier.
inline Sign3 orient2d_zero_line(const Vec2d& a, const Vec2d& b, const Vec2d& c) noexcept {
  if (same_bits(a.x, b.x) && (same_bits(a.y, b.y) || same_bits(a.x, c.x))) return Sign3::kZero;
  return same_bits(a.y, b.y, c.y) ? Sign3::kZero : Sign3::kUncertain;
}

inline Sign orient2d_after_filter(const Vec2d& a, const Vec2d& b, const Vec2d& c,
                                  TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&]() VT_TIER { return orient2d_zero_line(a, b, c); },
      [&](TierCounts* t) VT_TIER { return orient2d_off_axes(a, b, c, t); });
}
}  // namespace internal

inline Sign orient2d(const Vec2d& a, const Vec2d& b, const Vec2d& c, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return orient2d_filter(a, b, c); },
      [&](TierCounts* t) VT_TIER { return internal::orient2d_after_filter(a, b, c, t); });
}

}  // namespace veritope
