// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/in_circle.h: on which side of the circle through a, b, c does d lie?
// Source: [She97] bound A, with terms for underflow.  Bound: docs/bounds/in_circle.md.
#pragma once
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/filter.h"

namespace veritope {

/// The exact sign of the lifted determinant. If orient2d(a, b, c) > 0: positive iff d lies inside
/// the circle through a, b, c, zero iff on it, negative iff outside. Laws:
///   (1) swapping two of the four points negates it;
///   (2) it does not change when all points move by the same vector exactly, or are scaled by one
///       power of two;
///   (3) it is zero iff two of the points coincide or all four lie on one circle or one line.
/// REQUIRES finite coordinates; all are allowed, the subnormal and the largest included.
Sign in_circle(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d,
               TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (10u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/in_circle.md, and again in tests/predicates/in_circle_bound_test.cc.
/// Needs    round to nearest, gradual underflow, no contraction (robust/base/fp_guard.h).
Sign3 in_circle_filter(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;

namespace internal {
inline constexpr double kInCircleRel = 0x1.400000000000cp-50;
inline constexpr double kInCircleEta = 0x1p-900;

Sign3 in_circle_lattice(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;
Sign3 in_circle_interval(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;
Sign in_circle_exact(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;
Sign in_circle_after_filter(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d,
                            TierCounts* tally) noexcept;
}  // namespace internal

// Bodies.

namespace internal {
inline double in_circle_error(const formulas::InCircle<FilterReal>& f, double floor) {
  return kInCircleRel * f.magnitude([](double v) { return std::abs(v); }) +
         (kInCircleEta * f.size() + floor);
}
}  // namespace internal

inline Sign3 in_circle_filter(const Vec2d& a, const Vec2d& b, const Vec2d& c,
                              const Vec2d& d) noexcept {
  const formulas::InCircle<FilterReal> f(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y);
  return sign_beyond(f.det(), [&](double floor) { return internal::in_circle_error(f, floor); });
}

inline Sign in_circle(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d,
                      TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return in_circle_filter(a, b, c, d); },
      [&](TierCounts* t) VT_TIER { return internal::in_circle_after_filter(a, b, c, d, t); });
}

}  // namespace veritope
