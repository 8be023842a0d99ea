// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/segment_segment2d.h"

#include <utility>

#include "predicates/orient2d.h"

namespace veritope {
namespace {

// Order along a line: by x, then by y. Comparing doubles is exact.
bool before(Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

SegmentContact on_one_line(Vec2d p0, Vec2d p1, Vec2d q0, Vec2d q1) {
  if (before(p1, p0)) std::swap(p0, p1);
  if (before(q1, q0)) std::swap(q0, q1);
  const Vec2d first = before(p0, q0) ? q0 : p0, last = before(p1, q1) ? p1 : q1;
  if (before(last, first)) return SegmentContact::kDisjoint;
  if (before(first, last)) return SegmentContact::kOverlap;
  const bool end_of_p = first == p0 || first == p1, end_of_q = first == q0 || first == q1;
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
