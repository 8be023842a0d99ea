// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/rational_clip_oracle.h: the contact of two triangles with any finite
// coordinates, by cutting one with the half-spaces of the other over GMP's rationals. Slow; shares
// no line with predicates/.
#pragma once
#include <gmpxx.h>

#include <array>
#include <vector>

#include "predicates/segment_triangle.h"
#include "predicates/triangle_triangle.h"

namespace veritope::oracle {

using QPoint = std::array<mpq_class, 3>;

inline QPoint exact(const Vec3d& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }
inline QPoint minus(const QPoint& a, const QPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline QPoint cross(const QPoint& a, const QPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline mpq_class dot(const QPoint& a, const QPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline bool is_zero(const QPoint& a) { return sgn(a[0]) == 0 && sgn(a[1]) == 0 && sgn(a[2]) == 0; }

/// The part of the convex polygon where n . (p - through) >= 0.
inline std::vector<QPoint> cut(const std::vector<QPoint>& polygon, const QPoint& n,
                               const QPoint& through) {
  std::vector<QPoint> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const QPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const mpq_class hp = dot(n, minus(p, through)), hq = dot(n, minus(q, through));
    if (sgn(hp) >= 0) out.push_back(p);
    if (sgn(hp) * sgn(hq) < 0) {
      const mpq_class s = hp / (hp - hq);
      QPoint x;
      for (int k = 0; k < 3; ++k) x[k] = p[k] + s * (q[k] - p[k]);
      out.push_back(x);
    }
  }
  return out;
}

/// Points whose hull is what the hull of `points` and the triangle u have in common. REQUIRES u
/// non-degenerate.
inline std::vector<QPoint> intersection(std::vector<QPoint> points,
                                        const std::array<QPoint, 3>& u) {
  QPoint n = cross(minus(u[1], u[0]), minus(u[2], u[0]));
  for (int i = 0; i < 3; ++i) points = cut(points, cross(n, minus(u[(i + 1) % 3], u[i])), u[i]);
  points = cut(points, n, u[0]);
  for (mpq_class& c : n) c = -c;
  return cut(points, n, u[0]);
}

inline bool on_segment(const QPoint& p, const QPoint& a, const QPoint& b) {
  const QPoint e = minus(b, a), d = minus(p, a);
  if (is_zero(e)) return is_zero(d);
  return is_zero(cross(e, d)) && sgn(dot(e, d)) >= 0 && dot(e, d) <= dot(e, e);
}

inline std::array<QPoint, 3> exact(const std::array<Vec3d, 3>& t) {
  return {exact(t[0]), exact(t[1]), exact(t[2])};
}

inline bool degenerate(const std::array<Vec3d, 3>& t) {
  const std::array<QPoint, 3> q = exact(t);
  return is_zero(cross(minus(q[1], q[0]), minus(q[2], q[0])));
}

inline TriangleContact contact(const IndexedTriangle& t, const IndexedTriangle& u) {
  const std::array<QPoint, 3> a = exact(t.point), b = exact(u.point);
  std::vector<QPoint> common;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (t.id[i] == u.id[j]) common.push_back(a[i]);
    }
  }
  if (common.size() == 3) return TriangleContact::kIdentical;
  bool outside = false;
  for (const QPoint& p : intersection({a.begin(), a.end()}, b)) {
    outside = outside || common.empty() || !on_segment(p, common.front(), common.back());
  }
  if (outside) {
    const QPoint n = cross(minus(b[1], b[0]), minus(b[2], b[0]));
    bool coplanar = true;
    for (const QPoint& p : a) coplanar = coplanar && sgn(dot(n, minus(p, b[0]))) == 0;
    return coplanar ? TriangleContact::kCoplanarOverlap : TriangleContact::kImproper;
  }
  return common.empty()
             ? TriangleContact::kDisjoint
             : (common.size() == 1 ? TriangleContact::kSharedVertex : TriangleContact::kSharedEdge);
}

inline SegmentTriangleContact contact(const Vec3d& p, const Vec3d& q,
                                      const std::array<Vec3d, 3>& t) {
  const std::array<QPoint, 3> u = exact(t);
  const QPoint a = exact(p), b = exact(q);
  const std::vector<QPoint> meet = intersection({a, b}, u);
  if (meet.empty()) return {};
  for (const QPoint& m : meet) {
    if (m != meet[0]) return {SegmentTriangleKind::kOverlap, 0, false};
  }
  const bool at_end = meet[0] == a || meet[0] == b;
  for (int i = 0; i < 3; ++i) {
    if (meet[0] == u[i]) return {SegmentTriangleKind::kVertex, i, at_end};
  }
  for (int i = 0; i < 3; ++i) {
    if (on_segment(meet[0], u[i], u[(i + 1) % 3])) return {SegmentTriangleKind::kEdge, i, at_end};
  }
  return {SegmentTriangleKind::kInterior, 0, at_end};
}

}  // namespace veritope::oracle
