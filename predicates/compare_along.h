// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/compare_along.h: which of two points comes later in a direction?
// Bound: docs/bounds/compare_along.md.
#pragma once
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/filter.h"

namespace veritope {

/// The exact sign of direction . (p - q): positive iff p comes after q. Swapping p and q, or
/// reversing the direction, negates it; the zero direction gives zero.
/// REQUIRES finite numbers; all are allowed.
Sign compare_along(const Vec3d& direction, const Vec3d& p, const Vec3d& q,
                   TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (3u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/compare_along.md, and again in
///          tests/predicates/compare_along_bound_test.cc.
/// Needs    round to nearest, gradual underflow, no contraction (robust/base/fp_guard.h).
Sign3 compare_along_filter(const Vec3d& direction, const Vec3d& p, const Vec3d& q) noexcept;

namespace internal {
inline constexpr double kCompareAlongRel = 0x1.8000000000007p-52;

Sign3 compare_along_lattice(const Vec3d& direction, const Vec3d& p, const Vec3d& q) noexcept;
Sign3 compare_along_interval(const Vec3d& direction, const Vec3d& p, const Vec3d& q) noexcept;
Sign compare_along_exact(const Vec3d& direction, const Vec3d& p, const Vec3d& q) noexcept;
Sign compare_along_after_filter(const Vec3d& direction, const Vec3d& p, const Vec3d& q,
                                TierCounts* tally) noexcept;
}  // namespace internal

// Bodies.

inline Sign3 compare_along_filter(const Vec3d& direction, const Vec3d& p, const Vec3d& q) noexcept {
  const formulas::CompareAlong<FilterReal> f(direction.x, direction.y, direction.z, p.x, p.y, p.z,
                                             q.x, q.y, q.z);
  const double size = f.magnitude([](double v) { return std::abs(v); });
  return sign_beyond(f.det(), internal::kCompareAlongRel * size);
}

inline Sign compare_along(const Vec3d& direction, const Vec3d& p, const Vec3d& q,
                          TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return compare_along_filter(direction, p, q); },
      [&](TierCounts* t)
          VT_TIER { return internal::compare_along_after_filter(direction, p, q, t); });
}

}  // namespace veritope
