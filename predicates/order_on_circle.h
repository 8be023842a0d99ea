// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/order_on_circle.h: which of two points comes first when one turns round a centre?
#pragma once
#include "predicates/vec.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"

namespace veritope {

/// Turning counter-clockwise round c, from the ray through p, by less than a full turn: positive iff
/// the ray from c through q comes before the one through r, zero iff both are the same ray. The ray
/// through p itself is the first one. Only directions count: the points need not lie on a circle.
/// Exact: decided by signs of orient2d and order_along_line2d, which tally counts one by one.
/// Laws:
///   (1) swapping q and r negates it;
///   (2) if p, q, r lie on different rays, a cyclic shift of them keeps it;
///   (3) it does not change when all points move by the same vector exactly, or are scaled by one
///       power of two.
/// Degenerate input: zero if p, q or r is c.
/// REQUIRES finite coordinates; all are allowed, the subnormal and the largest included.
Sign order_on_circle(const Vec2d& c, const Vec2d& p, const Vec2d& q, const Vec2d& r,
                     TierCounts* tally = nullptr) noexcept;

}  // namespace veritope
