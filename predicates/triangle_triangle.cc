// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/triangle_triangle.h"

#include <utility>

#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "predicates/triangle_triangle_internal.h"

namespace veritope {
namespace {

using Contact = TriangleContact;
using Corners = std::array<const Vec3d*, 3>;

// The corners with `first` in front, cyclic order kept.
Corners rotated(const IndexedTriangle& t, int first) {
  const int second = first == 2 ? 0 : first + 1;
  const int third = first == 0 ? 2 : first - 1;
  return {&t.point[first], &t.point[second], &t.point[third]};
}

// Signs of some points over the plane of three corners. The filter is asked about all of them before a more expensive
// tier is asked about any, because the filter's answers alone often settle the pair.
template <int N>
class SignsOverPlane {
 public:
  SignsOverPlane(const Corners& plane, const std::array<const Vec3d*, N>& points, TierCounts* tally)
      : plane_(plane), points_(points), tally_(tally) {
    const Orient3dPlaneFilter filter(*plane[0], *plane[1], *plane[2]);
    for (int i = 0; i < N; ++i) {
      sign_[i] = filter(*points[i]);
      if (tally != nullptr && is_certain(sign_[i])) ++tally->decided[0];
    }
  }
  // True if all are certain and strictly on one side.
  bool on_one_side() const {
    bool same = is_certain(sign_[0]) && sign_[0] != Sign3::kZero;
    for (int i = 1; i < N; ++i) same = same && sign_[i] == sign_[0];
    return same;
  }
  std::array<Sign, N> resolve() {
    std::array<Sign, N> out;
    for (int i = 0; i < N; ++i) {
      if (!is_certain(sign_[i])) {
        sign_[i] = to_sign3(internal::orient3d_after_filter(*plane_[0], *plane_[1], *plane_[2],
                                                            *points_[i], tally_));
      }
      out[i] = to_sign(sign_[i]);
    }
    return out;
  }

 private:
  const Corners plane_;
  const std::array<const Vec3d*, N> points_;
  TierCounts* const tally_;
  std::array<Sign3, N> sign_;
};

// A plane seen along an axis, turned over if need be so that `t` is counter-clockwise.
class PlaneView {
 public:
  PlaneView(const Corners& t, TierCounts* tally)
      : projection_(projection_of(*t[0], *t[1], *t[2])), tally_(tally) {}
  Sign turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    return projection_.sign * orient2d(drop_axis(a, projection_.axis),
                                       drop_axis(b, projection_.axis),
                                       drop_axis(c, projection_.axis), tally_);
  }

 private:
  const AxisProjection projection_;
  TierCounts* const tally_;
};

// Is some edge line of the counter-clockwise t strictly between t and u? For closed convex polygons
// with interior, one of the two polygons' edge lines does that iff they are disjoint: the Minkowski
// difference has no other edge directions.
bool edge_separates(const Corners& t, const Corners& u, const PlaneView& view) {
  for (int i = 0; i < 3; ++i) {
    const Vec3d &a = *t[i], &b = *t[i == 2 ? 0 : i + 1];
    if (view.turn(a, b, *u[0]) == Sign::kNegative && view.turn(a, b, *u[1]) == Sign::kNegative &&
        view.turn(a, b, *u[2]) == Sign::kNegative) {
      return true;
    }
  }
  return false;
}

Corners counter_clockwise(Corners u, const PlaneView& view) {
  if (view.turn(*u[0], *u[1], *u[2]) == Sign::kNegative) std::swap(u[1], u[2]);
  return u;
}

Contact coplanar_strangers(const Corners& t, const Corners& u, TierCounts* tally) {
  const PlaneView view(t, tally);
  const Corners v = counter_clockwise(u, view);
  return edge_separates(t, v, view) || edge_separates(v, t, view) ? Contact::kDisjoint
                                                                  : Contact::kCoplanarOverlap;
}

// Does the closed angle at c[0] from c[1] counter-clockwise to c[2], less than a half turn, contain
// p? REQUIRES p != c[0].
bool angle_contains(const Corners& c, const Vec3d& p, const PlaneView& view) {
  return view.turn(*c[0], *c[1], p) != Sign::kNegative &&
         view.turn(*c[0], p, *c[2]) != Sign::kNegative;
}

// t[0] = u[0] is the common vertex. Near it both triangles are angles, and convex: they meet
// elsewhere iff the angles share a ray; two closed arcs shorter than a half turn share a direction
// iff an end of v lies in t, or t lies in v with both its ends.
Contact coplanar_shared_vertex(const Corners& t, const Corners& u, TierCounts* tally) {
  const PlaneView view(t, tally);
  const Corners v = counter_clockwise(u, view);
  return angle_contains(t, *v[1], view) || angle_contains(t, *v[2], view) ||
                 angle_contains(v, *t[1], view)
             ? Contact::kCoplanarOverlap
             : Contact::kSharedVertex;
}

Contact strangers(const IndexedTriangle& a, const IndexedTriangle& b, TierCounts* tally) {
  const Corners t = rotated(a, 0), u = rotated(b, 0);
  SignsOverPlane<3> u_over_t(t, u, tally);
  if (u_over_t.on_one_side()) return Contact::kDisjoint;
  SignsOverPlane<3> t_over_u(u, t, tally);
  if (t_over_u.on_one_side()) return Contact::kDisjoint;
  const std::array<Sign, 3> su = u_over_t.resolve();
  if (u_over_t.on_one_side()) return Contact::kDisjoint;
  if (su[0] == Sign::kZero && su[1] == Sign::kZero && su[2] == Sign::kZero) {
    return coplanar_strangers(t, u, tally);
  }
  const std::array<Sign, 3> st = t_over_u.resolve();
  if (t_over_u.on_one_side()) return Contact::kDisjoint;

  // Both meet the line of the two planes, in segments whose ends plane_section names. Its l is n_t
  // x n_u for t, the opposite for u. For an edge of t from below to above u's plane, which meets
  // the line in p, and one of u from below to above t's plane, which meets it in q: orient3d(t
  // edge, u edge) is the sign of (q - p) . (n_t x n_u).
  const internal::PlaneSection on_t = internal::plane_section(st),
                               on_u = internal::plane_section(su);
  const auto order = [&](internal::PlaneCrossing p, internal::PlaneCrossing q) {
    return orient3d(*t[p.below], *t[p.above], *u[q.below], *u[q.above], tally);
  };
  const bool apart =
      order(on_t.falling, on_u.falling) == Sign::kPositive ||  // t ends before u begins
      order(on_t.rising, on_u.rising) == Sign::kNegative;      // u ends before t begins
  return apart ? Contact::kDisjoint : Contact::kImproper;
}

// t[0] = u[0] = v. If the planes differ, a point other than v is common iff both triangles reach
// along the line of the planes, on the same side of v. A triangle reaches iff its other corners are
// not strictly on one side of the other plane; and with the frame of plane_section, t reaches along
// +(n_t x n_u) iff its boundary falls from t[1] to t[2], u iff it rises from u[1] to u[2].
Contact shared_vertex(const IndexedTriangle& a, int i, const IndexedTriangle& b, int j,
                      TierCounts* tally) {
  const Corners t = rotated(a, i), u = rotated(b, j);
  SignsOverPlane<2> u_over_t(t, {u[1], u[2]}, tally);
  if (u_over_t.on_one_side()) return Contact::kSharedVertex;
  SignsOverPlane<2> t_over_u(u, {t[1], t[2]}, tally);
  if (t_over_u.on_one_side()) return Contact::kSharedVertex;
  const std::array<Sign, 2> su = u_over_t.resolve();
  if (u_over_t.on_one_side()) return Contact::kSharedVertex;
  if (su[0] == Sign::kZero && su[1] == Sign::kZero) return coplanar_shared_vertex(t, u, tally);
  const std::array<Sign, 2> st = t_over_u.resolve();
  if (t_over_u.on_one_side()) return Contact::kSharedVertex;
  const bool t_forward = to_int(st[0]) > to_int(st[1]);
  const bool u_forward = to_int(su[0]) < to_int(su[1]);
  return t_forward == u_forward ? Contact::kImproper : Contact::kSharedVertex;
}

// The corners named i of t and j of u are those off the common edge.
Contact shared_edge(const IndexedTriangle& a, int i, const IndexedTriangle& b, int j,
                    TierCounts* tally) {
  const Corners t = rotated(a, i);
  const Vec3d& apex = b.point[j];
  if (orient3d(*t[0], *t[1], *t[2], apex, tally) != Sign::kZero) return Contact::kSharedEdge;
  // A table: a branch on this sign is as good as random, and a mispredicted one costs half of the decision.
  static constexpr Contact kBySign[] = {Contact::kSharedEdge, Contact::kSharedEdge,
                                        Contact::kCoplanarOverlap};
  return kBySign[to_int(PlaneView(t, tally).turn(*t[1], *t[2], apex)) + 1];
}

}  // namespace

TriangleContact triangle_triangle(const IndexedTriangle& t, const IndexedTriangle& u,
                                  TierCounts* tally) noexcept {
  int common = 0, t_sum = 0, u_sum = 0;  // of the numbers of the common corners
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (t.id[i] == u.id[j]) ++common, t_sum += i, u_sum += j;
    }
  }
  switch (common) {
    case 0: return strangers(t, u, tally);
    case 1: return shared_vertex(t, t_sum, u, u_sum, tally);
    case 2: return shared_edge(t, 3 - t_sum, u, 3 - u_sum, tally);
    default: return Contact::kIdentical;
  }
}

}  // namespace veritope
