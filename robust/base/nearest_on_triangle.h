// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/nearest_on_triangle.h: the nearest point of a triangle, in binary64.
#pragma once
#include <array>
#include <cstddef>

#include "robust/base/box3d.h"

namespace veritope {

/// The point of the triangle a, b, c that is nearest to p, up to rounding errors: by the regions of its corners, sides
/// and inside. Source: Ericson, Real-Time Collision Detection, section 5.1.5.
inline Point3d approx_nearest_on_triangle(const Point3d& p, const Point3d& a, const Point3d& b,
                                          const Point3d& c) {
  const auto minus = [](const Point3d& x, const Point3d& y) {
    return Point3d{x[0] - y[0], x[1] - y[1], x[2] - y[2]};
  };
  const auto dot = [](const Point3d& x, const Point3d& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  const auto mixed = [&](double v, double w) {
    Point3d out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = a[k] + v * (b[k] - a[k]) + w * (c[k] - a[k]);
    return out;
  };
  const Point3d ab = minus(b, a), ac = minus(c, a), ap = minus(p, a), bp = minus(p, b),
                cp = minus(p, c);
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp),
               d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return mixed(d1 / (d1 - d3), 0);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return mixed(0, d2 / (d2 - d6));
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return mixed(1 - w, w);
  }
  const double sum = va + vb + vc;
  return mixed(vb / sum, vc / sum);
}

}  // namespace veritope
