// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/segment_triangle.h"

#include <utility>

#include "predicates/order_on_line.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"

namespace veritope {
namespace {

using Kind = SegmentTriangleKind;
using Contact = SegmentTriangleContact;

constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }

// The part of the triangle on which a point lies that has the signs s[i] (+ inside, no - among
// them) over the edges i, next(i).
Contact part_of(const std::array<Sign, 3>& s, bool at_end) {
  for (int i = 0; i < 3; ++i) {
    if (s[i] != Sign::kZero) continue;
    if (s[next(i)] == Sign::kZero) return {Kind::kVertex, next(i), at_end};
    if (s[previous(i)] == Sign::kZero) return {Kind::kVertex, i, at_end};
    return {Kind::kEdge, i, at_end};
  }
  return {Kind::kInterior, 0, at_end};
}

bool any_negative(const std::array<Sign, 3>& s) {
  return s[0] == Sign::kNegative || s[1] == Sign::kNegative || s[2] == Sign::kNegative;
}

// Segment and triangle in one plane, seen along an axis so that t turns counter-clockwise.
class InPlane {
 public:
  InPlane(const Vec3d& p, const Vec3d& q, const std::array<Vec3d, 3>& t, TierCounts* tally)
      : view_(projection_of(t[0], t[1], t[2])), tally_(tally), p_(see(p)), q_(see(q)) {
    for (int i = 0; i < 3; ++i) t_[i] = see(t[i]);
  }

  Contact contact() const {
    std::array<Sign, 3> over_p, over_q,
        over_line;  // edges over p and q; corners over the segment's line
    for (int i = 0; i < 3; ++i) {
      over_p[i] = turn(t_[i], t_[next(i)], p_);
      over_q[i] = turn(t_[i], t_[next(i)], q_);
    }
    if (p_ == q_) return any_negative(over_p) ? Contact{} : part_of(over_p, true);
    for (int i = 0; i < 3; ++i) {
      over_line[i] = turn(p_, q_, t_[i]);
      if (over_p[i] == Sign::kNegative && over_q[i] == Sign::kNegative) return {};
    }
    if (over_line[0] == over_line[1] && over_line[1] == over_line[2])
      return {};  // the corners are not on one line
    // No edge line and not the segment's own line separates the two strictly: they meet (separating
    // axes in the plane). They meet in one point iff one of these lines separates them weakly.
    for (int i = 0; i < 3; ++i) {
      if (over_p[i] == Sign::kZero && over_q[i] == Sign::kZero) return along_edge(i);
    }
    for (int i = 0; i < 3; ++i) {
      if (over_p[i] == Sign::kZero && over_q[i] == Sign::kNegative) return part_of(over_p, true);
      if (over_q[i] == Sign::kZero && over_p[i] == Sign::kNegative) return part_of(over_q, true);
    }
    for (int i = 0; i < 3; ++i) {
      if (over_line[i] == Sign::kZero && over_line[next(i)] == over_line[previous(i)]) {
        return {Kind::kVertex, i, false};  // an end there would be weakly outside an edge
      }
    }
    return {Kind::kOverlap, 0, false};
  }

 private:
  // The segment lies on the line of the edge from corner i, and meets it: no other edge separated
  // them.
  Contact along_edge(int i) const {
    Vec2d p = p_, q = q_, a = t_[i], b = t_[next(i)];
    if (internal::is_before(q, p)) std::swap(p, q);
    const bool turned = internal::is_before(b, a);
    if (turned) std::swap(a, b);
    if (internal::is_same(q, a)) return {Kind::kVertex, turned ? next(i) : i, true};
    if (internal::is_same(b, p)) return {Kind::kVertex, turned ? i : next(i), true};
    return {Kind::kOverlap, 0, false};
  }
  Vec2d see(const Vec3d& v) const { return drop_axis(v, view_.axis); }
  Sign turn(Vec2d a, Vec2d b, Vec2d c) const { return view_.sign * orient2d(a, b, c, tally_); }

  const AxisProjection view_;
  TierCounts* const tally_;
  const Vec2d p_, q_;
  std::array<Vec2d, 3> t_;
};

}  // namespace

SegmentTriangleContact segment_triangle(const Vec3d& p, const Vec3d& q,
                                        const std::array<Vec3d, 3>& t, TierCounts* tally) noexcept {
  const Sign sp = orient3d(t[0], t[1], t[2], p, tally), sq = orient3d(t[0], t[1], t[2], q, tally);
  if (sp * sq == Sign::kPositive) return {};
  if (sp == Sign::kZero && sq == Sign::kZero) return InPlane(p, q, t, tally).contact();
  // At most one end is on the plane. The line goes down through the plane (from p, if p is above) and passes the edge i
  // on its inner side iff the edge and the segment make a positive volume.
  const bool down = sp == Sign::kPositive || sq == Sign::kNegative;
  const Vec3d &above = down ? p : q, &below = down ? q : p;
  std::array<Sign, 3> s;
  for (int i = 0; i < 3; ++i) {
    s[i] = orient3d(below, above, t[i], t[next(i)], tally);
    if (s[i] == Sign::kNegative) return {};
  }
  return part_of(s, sp == Sign::kZero || sq == Sign::kZero);
}

}  // namespace veritope
