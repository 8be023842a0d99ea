// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/order_on_circle.h"

#include "predicates/generated/order_along_line2d.h"
#include "predicates/order_on_line.h"
#include "predicates/orient2d.h"

namespace veritope {
namespace {

// Where the ray from c through x is, seen from the one through p: 0 on it, 1 less than half a turn
// away, 2 opposite, 3 more than half a turn away. REQUIRES p != c and x != c.
int quarter(const Vec2d& c, const Vec2d& p, const Vec2d& x, TierCounts* tally) {
  switch (orient2d(c, p, x, tally)) {
    case Sign::kPositive: return 1;
    case Sign::kNegative: return 3;
    case Sign::kZero: break;
  }
  return order_along_line2d(c, p, x, c, tally) == Sign::kPositive ? 0 : 2;
}

}  // namespace

Sign order_on_circle(const Vec2d& c, const Vec2d& p, const Vec2d& q, const Vec2d& r,
                     TierCounts* tally) noexcept {
  using internal::is_same;
  if (is_same(p, c) || is_same(q, c) || is_same(r, c)) return Sign::kZero;
  const int of_q = quarter(c, p, q, tally), of_r = quarter(c, p, r, tally);
  if (of_q != of_r) return of_q < of_r ? Sign::kPositive : Sign::kNegative;
  return of_q % 2 == 0 ? Sign::kZero : orient2d(c, q, r, tally);
}

}  // namespace veritope
