// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/segment_segment2d.h"

#include <utility>

#include "predicates/order_on_line.h"
#include "predicates/orient2d.h"

namespace veritope {
namespace {

using internal::is_before;
using internal::is_same;

SegmentContact on_one_line(Vec2d p0, Vec2d p1, Vec2d q0, Vec2d q1) {
  if (is_before(p1, p0)) std::swap(p0, p1);
  if (is_before(q1, q0)) std::swap(q0, q1);
  const Vec2d first = is_before(p0, q0) ? q0 : p0, last = is_before(p1, q1) ? p1 : q1;
  if (is_before(last, first)) return SegmentContact::kDisjoint;
  if (is_before(first, last)) return SegmentContact::kOverlap;
  const bool end_of_p = is_same(first, p0) || is_same(first, p1),
             end_of_q = is_same(first, q0) || is_same(first, q1);
  return end_of_p && end_of_q ? SegmentContact::kEnds : SegmentContact::kEndInside;
}

}  // namespace

SegmentContact segment_segment2d(Vec2d p0, Vec2d p1, Vec2d q0, Vec2d q1,
                                 TierCounts* tally) noexcept {
  const Sign a = orient2d(p0, p1, q0, tally), b = orient2d(p0, p1, q1, tally);
  if (a * b == Sign::kPositive) return SegmentContact::kDisjoint;
  const Sign c = orient2d(q0, q1, p0, tally), d = orient2d(q0, q1, p1, tally);
  if (c * d == Sign::kPositive) return SegmentContact::kDisjoint;
  // A segment that is a point makes two of the signs zero; if it is off the other's line, the other
  // two agreed above.
  if (a == Sign::kZero && b == Sign::kZero) return on_one_line(p0, p1, q0, q1);
  const bool end_of_q = a == Sign::kZero || b == Sign::kZero,
             end_of_p = c == Sign::kZero || d == Sign::kZero;
  if (end_of_p && end_of_q) return SegmentContact::kEnds;
  return end_of_p || end_of_q ? SegmentContact::kEndInside : SegmentContact::kCrossing;
}

}  // namespace veritope
