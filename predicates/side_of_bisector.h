// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/side_of_bisector.h: on which side of the bisector of a and b does p lie? compare_distance
// with its arguments in the order of a side: the separating pair first, the point last.
#pragma once
#include "predicates/generated/compare_distance2d.h"
#include "predicates/generated/compare_distance3d.h"

namespace veritope {

/// The exact sign of |b - p|^2 - |a - p|^2: positive iff p lies on the side of a, zero iff on the bisector.
/// a = b gives zero: there is no bisector. Swapping a and b negates it.
/// REQUIRES finite coordinates; all are allowed, the subnormal and the largest included.
inline Sign side_of_bisector2d(const Vec2d& a, const Vec2d& b, const Vec2d& p,
                               TierCounts* tally = nullptr) noexcept {
  return compare_distance2d(p, b, a, tally);
}
inline Sign side_of_bisector3d(const Vec3d& a, const Vec3d& b, const Vec3d& p,
                               TierCounts* tally = nullptr) noexcept {
  return compare_distance3d(p, b, a, tally);
}

}  // namespace veritope
