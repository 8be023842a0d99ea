// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/quad_gap_internal.h"

#include <algorithm>
#include <limits>

#include "interval/box.h"

namespace veritope::internal {
namespace {

Box3 way(const Vec3d& from, const Vec3d& to) {
  return Box3(Interval(to.x) - Interval(from.x), Interval(to.y) - Interval(from.y),
              Interval(to.z) - Interval(from.z));
}
double most_length(const Box3& v) {
  const Interval length = sqrt(sqr(v[0]) + sqr(v[1]) + sqr(v[2]));
  return length.is_empty() ? std::numeric_limits<double>::infinity() : length.hi();
}
double approx_dot(const Box3& a, const Box3& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += a[k].hi() * b[k].hi();
  return sum;
}

}  // namespace

// The patch is a + u e + v f + u v g with e = b - a, f = d - a, g = a - b - d + c.
//   (1) Equal parameters: the distance to the triangles is at most |g| / 4.
//   (2) With any numbers r, s and h = g - r e - s f, the patch is a + x e + y f + z h, where x = u + r u v, y = v +
//       s u v, z = u v. If r, s, r + s > -1, then (u, v) -> (x, y) takes the square to a convex quadrilateral, one
//       to one and onto. The triangles are a + x e + y f + z' h over the same (x, y), with z' from 0 to 1. So the
//       distance is at most |h|: 0 if the four points lie in a plane.
double quad_gap(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, double enough) {
  const Box3 e = way(a, b), f = way(a, d), g = way(b, c) - f;
  const double whole = most_length(g) / 4;
  if (whole <= enough) return whole;
  const double ee = approx_dot(e, e), ef = approx_dot(e, f), ff = approx_dot(f, f),
               ge = approx_dot(g, e), gf = approx_dot(g, f);
  const double det = ee * ff - ef * ef;
  if (!(det > 0)) return whole;
  const double r = (ge * ff - gf * ef) / det, s = (gf * ee - ge * ef) / det;
  constexpr double kLeast = -0.999;
  if (!(r > kLeast && s > kLeast && r + s > kLeast && r < 1e6 && s < 1e6)) return whole;
  return std::min(whole, most_length(g - Interval(r) * e - Interval(s) * f));
}

}  // namespace veritope::internal
