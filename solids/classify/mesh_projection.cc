// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/mesh_projection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {

using namespace internal;

namespace {

ExactPoint vector_from(const ExactPoint& a, const ExactPoint& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}
Rational product_of(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The nearest point of the segment from a to b, and whether it is a (-1), b (1) or between.
std::pair<ExactPoint, int> nearest_of_segment(const ExactPoint& q, const ExactPoint& a,
                                              const ExactPoint& b) {
  const ExactPoint u = vector_from(a, b);
  const Rational along = product_of(u, vector_from(a, q)), length = product_of(u, u);
  if (along.sign() != Sign::kPositive) return {a, -1};
  if (along >= length) return {b, 1};
  const Rational t = along / length;
  return {{a[0] + t * u[0], a[1] + t * u[1], a[2] + t * u[2]}, 0};
}

// The nearest point of a triangle: the foot on its plane if that lies inside, else the nearest one of its sides.
NearestPoint nearest_of_triangle(const ExactPoint& q, const std::array<ExactPoint, 3>& t) {
  NearestPoint out;
  const ExactPoint u = vector_from(t[0], t[1]), v = vector_from(t[0], t[2]),
                   w = vector_from(t[0], q);
  const Rational uu = product_of(u, u), uv = product_of(u, v), vv = product_of(v, v),
                 uw = product_of(u, w), vw = product_of(v, w), det = uu * vv - uv * uv;
  VT_CHECK(det.sign() == Sign::kPositive, "a degenerate facet has no projection");
  const Rational r = vv * uw - uv * vw, s = uu * vw - uv * uw;
  if (r.sign() == Sign::kPositive && s.sign() == Sign::kPositive && r + s < det) {
    const Rational a = r / det, b = s / det;
    for (std::size_t c = 0; c < 3; ++c) out.point[c] = t[0][c] + a * u[c] + b * v[c];
    return out;
  }
  Rational least;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto foot = nearest_of_segment(q, t[i], t[(i + 1) % 3]);
    const ExactPoint d = vector_from(foot.first, q);
    const Rational distance = product_of(d, d);
    if (i > 0 && !(distance < least)) continue;
    least = distance;
    out.point = foot.first;
    out.feature = foot.second == 0 ? MeshFeature::kEdge : MeshFeature::kVertex;
    out.corner = foot.second == 1 ? (i + 1) % 3 : i;
  }
  return out;
}

// A lower bound of the squared distances between points of both boxes.
double least_squared_distance(const Box3& q, const Box3d& box) {
  Interval sum;
  for (std::size_t c = 0; c < 3; ++c) {
    const Interval below = Interval(box.lo[c]) - q[c], above = q[c] - Interval(box.hi[c]);
    const double gap = std::max({below.lo(), above.lo(), 0.0});
    sum += sqr(Interval(gap));
  }
  return sum.lo();
}

// Weights, not negative and of sum 1 but for rounding, of a point near the nearest one. Approximate.
Point3d approx_weights(const Point3d& q, const std::array<Point3d, 3>& t) {
  const auto minus = [](const Point3d& a, const Point3d& b) {
    return Point3d{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto times = [](const Point3d& a, const Point3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const Point3d u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(q, t[0]);
  const double uu = times(u, u), uv = times(u, v), vv = times(v, v), uw = times(u, w),
               vw = times(v, w), det = uu * vv - uv * uv;
  const double r = (vv * uw - uv * vw) / det, s = (uu * vw - uv * uw) / det;
  if (r >= 0 && s >= 0 && r + s <= 1) return {1 - r - s, r, s};
  Point3d best{1, 0, 0};
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Point3d e = minus(t[j], t[i]), d = minus(q, t[i]);
    const double a = std::min(std::max(times(e, d) / times(e, e), 0.0), 1.0);
    const Point3d from{d[0] - a * e[0], d[1] - a * e[1], d[2] - a * e[2]};
    if (!(times(from, from) < least)) continue;
    least = times(from, from);
    best = {};
    best[i] = 1 - a;
    best[j] = a;
  }
  return best;
}

// Encloses the squared distance from a point of q to the triangle. REQUIRES a live ScopedUpward.
Interval squared_distance(const Box3& q, const std::array<Vec3d, 3>& facet) {
  std::array<Point3d, 3> t;
  for (std::size_t i = 0; i < 3; ++i) t[i] = to_point(facet[i]);
  const Point3d middle = approx_middle(q), weights = approx_weights(middle, t);
  // Above: the distance of a point of the triangle, whose weights are not negative and add up to 1. Where rounding has
  // left the triangle, they are made a little smaller, and else a vertex serves.
  const auto usable = [](double w) { return std::isfinite(w) ? std::max(w, 0.0) : 0.0; };
  double a = usable(weights[1]), b = usable(weights[2]);
  if ((Interval(a) + Interval(b)).hi() > 1) {
    a = (Interval(a) * Interval(1 - 0x1p-50)).lo();
    b = (Interval(b) * Interval(1 - 0x1p-50)).lo();
  }
  if ((Interval(a) + Interval(b)).hi() > 1) a = b = 0;
  Box3 p;
  for (std::size_t c = 0; c < 3; ++c) {
    const Interval origin(t[0][c]);
    p[c] = origin + Interval(a) * (Interval(t[1][c]) - origin) +
           Interval(b) * (Interval(t[2][c]) - origin);
  }
  const Box3 d = q - p;
  const double most = (sqr(d[0]) + sqr(d[1]) + sqr(d[2])).hi();
  // Below: the triangle lies beyond the plane through its vertex that is nearest along the direction d.
  const Point3d direction = approx_middle(d);
  Box3 n;
  for (std::size_t c = 0; c < 3; ++c)
    n[c] = Interval(std::isfinite(direction[c]) ? direction[c] : 0.0);
  const Interval length = sqr(n[0]) + sqr(n[1]) + sqr(n[2]);
  double least = 0;
  if (length.lo() > 0) {
    double gap = HUGE_VAL;
    for (const Point3d& v : t)
      gap = std::min(gap, dot(n, q - Box3(Interval(v[0]), Interval(v[1]), Interval(v[2]))).lo());
    if (gap > 0 && gap < HUGE_VAL) least = (sqr(Interval(gap)) / length).lo();
  }
  return Interval::from_bounds(std::min(least, most), most);
}

}  // namespace

MeshProjection::MeshProjection(const TriangleMesh& mesh) : mesh_(&mesh) {
  VT_CHECK(!mesh.faces.empty(), "a mesh without facets has no nearest point");
  std::vector<Box3d> boxes;
  boxes.reserve(mesh.faces.size());
  for (const auto& t : mesh.faces) {
    Box3d box = empty_box();
    for (const std::uint32_t v : t) add(to_point(mesh.positions[v]), &box);
    boxes.push_back(box);
  }
  order_ = BoxHierarchy(boxes).order();
  tree_ = RangeTree<Box3d>(
      boxes.size(), 1, [&](std::uint32_t p) { return boxes[order_[p]]; },
      [](const Box3d& a, const Box3d& b) { return hull(a, b); });
}

MeshProjectionAnswer MeshProjection::project(const ExactPoint& point) const {
  const ScopedUpward upward;
  const Box3 q(enclose(point[0]), enclose(point[1]), enclose(point[2]));
  double bound = HUGE_VAL;  // the least squared distance is not greater
  struct Candidate {
    std::uint32_t facet;
    double least;
  };
  std::vector<Candidate> candidates;
  const auto visit = [&](auto& self, const TreeRange& r) -> void {
    if (r.is_leaf()) {
      const std::uint32_t f = order_[r.lo];
      const auto& t = mesh_->faces[f];
      const Interval d = squared_distance(
          q, {mesh_->positions[t[0]], mesh_->positions[t[1]], mesh_->positions[t[2]]});
      bound = std::min(bound, d.hi());
      if (d.lo() <= bound) candidates.push_back({f, d.lo()});
      return;
    }
    TreeRange near = r.left(), far = r.right();
    double near_gap = least_squared_distance(q, tree_[near]),
           far_gap = least_squared_distance(q, tree_[far]);
    if (far_gap < near_gap) {
      std::swap(near, far);
      std::swap(near_gap, far_gap);
    }
    if (near_gap <= bound) self(self, near);
    if (far_gap <= bound) self(self, far);
  };
  visit(visit, tree_.root());
  MeshProjectionAnswer out;
  for (const Candidate& c : candidates) {
    if (c.least > bound) continue;
    std::array<ExactPoint, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3d p = to_point(mesh_->positions[mesh_->faces[c.facet][i]]);
      for (std::size_t k = 0; k < 3; ++k) t[i][k] = Rational::from_double(p[k]);
    }
    NearestPoint nearest = nearest_of_triangle(point, t);
    nearest.facet = c.facet;
    const ExactPoint d = vector_from(nearest.point, point);
    Rational distance = product_of(d, d);
    if (!out.nearest.empty() && out.squared_distance < distance) continue;
    if (out.nearest.empty() || distance < out.squared_distance) out.nearest.clear();
    out.squared_distance = std::move(distance);
    out.nearest.push_back(std::move(nearest));
  }
  std::sort(out.nearest.begin(), out.nearest.end(),
            [](const NearestPoint& a, const NearestPoint& b) {
              return a.point != b.point ? a.point < b.point : a.facet < b.facet;
            });
  out.nearest.erase(
      std::unique(out.nearest.begin(), out.nearest.end(),
                  [](const NearestPoint& a, const NearestPoint& b) { return a.point == b.point; }),
      out.nearest.end());
  return out;
}

}  // namespace veritope
