// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "solids/micro/inside/facet_planes_internal.h"

namespace veritope::internal {

namespace {

Box3 point_box(const Vec3d& p) { return Box3(Interval(p.x), Interval(p.y), Interval(p.z)); }

}  // namespace

// Claim    |fl(d.m) - d.q| <= slack(d, points) for each point q, whatever the rounding mode is, if nothing overflows.
// Bound    fl(d.m) is the sum of three products; each product passes three roundings or fewer, each off by a factor
//          within 1 +- 2^-52, so it is off by |d_c m_c| 4 2^-52 or less, and |m_c| is less than twice the greatest
//          bound of the box; q differs from m by the radius. Underflow adds less than 2^-1060.
double dot_slack(const Point3d& d, const NodePoints& points) {
  Interval sum(0x1p-1060);
  for (std::size_t c = 0; c < 3; ++c) {
    const double most = std::max(std::abs(points.box.lo[c]), std::abs(points.box.hi[c]));
    sum += Interval(std::abs(d[c])) *
           (Interval(points.radius[c]) + Interval(0x1p-49) * Interval(most));
  }
  return sum.hi();
}

FacetPlanes::FacetPlanes(const TriangleMesh& mesh) : mesh_(&mesh) {
  const ScopedUpward upward;
  boxes_.reserve(mesh.faces.size());
  slabs_.resize(mesh.faces.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    Box3d box = empty_box();
    std::array<Box3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& q = mesh.positions[mesh.faces[f][i]];
      add(to_point(q), &box);
      p[i] = point_box(q);
    }
    boxes_.push_back(box);
    const Box3 normal = cross(p[1] - p[0], p[2] - p[0]);
    const std::array<Box3, 4> directions{normal, cross(normal, p[1] - p[0]),
                                         cross(normal, p[2] - p[1]), cross(normal, p[0] - p[2])};
    for (std::size_t k = 0; k < 4; ++k) {
      Slab& slab = slabs_[f][k];
      slab.direction = approx_middle(directions[k]);
      const auto& d = slab.direction;
      if (!std::isfinite(d[0] + d[1] + d[2])) slab.direction = {};
      const Box3 exact{Interval(d[0]), Interval(d[1]), Interval(d[2])};
      slab.lo = HUGE_VAL, slab.hi = -HUGE_VAL;
      for (const Box3& q : p) {
        const Interval at = dot(exact, q);
        slab.lo = std::min(slab.lo, at.lo());
        slab.hi = std::max(slab.hi, at.hi());
      }
    }
  }
  tree_ = BoxHierarchy(boxes_);
}

bool FacetPlanes::is_apart(std::uint32_t facet, const NodePoints& points) const {
  if (!meets(boxes_[facet], points.box)) return true;
  const auto &x = points.middles[0], &y = points.middles[1], &z = points.middles[2];
  for (const Slab& slab : slabs_[facet]) {
    const Point3d& d = slab.direction;
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double at = d[0] * x[i] + d[1] * y[i] + d[2] * z[i];
      lo = std::min(lo, at);
      hi = std::max(hi, at);
      if (lo <= slab.hi && slab.lo <= hi) break;
    }
    if (lo <= slab.hi && slab.lo <= hi) continue;
    const Interval slack(dot_slack(d, points));
    if (!std::isfinite(slack.hi()) || !std::isfinite(lo) || !std::isfinite(hi)) continue;
    if ((Interval(lo) - slack).lo() > slab.hi || (Interval(hi) + slack).hi() < slab.lo) return true;
  }
  return false;
}

}  // namespace veritope::internal
