// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/surface/node_points.h"

#include <algorithm>
#include <cmath>

#include "interval/box_geometry.h"

namespace veritope {

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

void NodePoints::assign(std::span<const Box3> points) {
  box = empty_box();
  radius = {};
  for (std::size_t c = 0; c < 3; ++c) {
    middles[c].resize(points.size());
    double most = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Interval& x = points[i][c];
      const double m = 0.5 * x.lo() + 0.5 * x.hi();
      middles[c][i] = m;
      most = std::max(most, mag(x - Interval(m)));
      box.lo[c] = std::min(box.lo[c], x.lo());
      box.hi[c] = std::max(box.hi[c], x.hi());
    }
    radius[c] = most;
  }
}

void NodePoints::widen(double by) {
  for (std::size_t c = 0; c < 3; ++c) {
    radius[c] += by;
    box.lo[c] = -(-box.lo[c] + by);  // rounded downward
    box.hi[c] += by;
  }
}

Slab slab_around(const Point3d& direction, std::span<const Box3> points) {
  Slab out{direction, HUGE_VAL, -HUGE_VAL};
  if (!std::isfinite(direction[0] + direction[1] + direction[2])) out.direction = {};
  const auto& d = out.direction;
  const Box3 exact{Interval(d[0]), Interval(d[1]), Interval(d[2])};
  for (const Box3& q : points) {
    const Interval at = internal::dot(exact, q);
    out.lo = std::min(out.lo, at.lo());
    out.hi = std::max(out.hi, at.hi());
  }
  return out;
}

bool is_beside(const Slab& slab, const NodePoints& points) {
  const auto &x = points.middles[0], &y = points.middles[1], &z = points.middles[2];
  const Point3d& d = slab.direction;
  double lo = HUGE_VAL, hi = -HUGE_VAL;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double at = d[0] * x[i] + d[1] * y[i] + d[2] * z[i];
    lo = std::min(lo, at);
    hi = std::max(hi, at);
    if (lo <= slab.hi && slab.lo <= hi) return false;
  }
  const Interval slack(dot_slack(d, points));
  if (!std::isfinite(slack.hi()) || !std::isfinite(lo) || !std::isfinite(hi)) return false;
  return (Interval(lo) - slack).lo() > slab.hi || (Interval(hi) + slack).hi() < slab.lo;
}

Box3d box_around(std::span<const Box3> points) {
  Box3d out = empty_box();
  for (const Box3& p : points)
    out = hull(out, Box3d{{p[0].lo(), p[1].lo(), p[2].lo()}, {p[0].hi(), p[1].hi(), p[2].hi()}});
  return out;
}

}  // namespace veritope
