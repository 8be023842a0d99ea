// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/order_on_line.h: the order of points along the line on which they lie, by x, then by y; in every
// floating-point environment.
#pragma once
#include "predicates/vec.h"
#include "robust/binary64.h"

namespace veritope::internal {

inline bool is_same(const Vec2d& a, const Vec2d& b) {
  return binary64_order(a.x) == binary64_order(b.x) && binary64_order(a.y) == binary64_order(b.y);
}
inline bool is_before(const Vec2d& a, const Vec2d& b) {
  const std::int64_t ax = binary64_order(a.x), bx = binary64_order(b.x);
  return ax < bx || (ax == bx && binary64_order(a.y) < binary64_order(b.y));
}

}  // namespace veritope::internal
