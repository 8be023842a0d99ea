// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "solids/classify/scaled_point_internal.h"

namespace veritope::internal {
namespace {

Dyadic difference(double a, double b) { return Dyadic::from_double(a) - Dyadic::from_double(b); }

// Finite beyond binary64, too: such a point lies far outside of every mesh.
double rounded_coordinate(const Rational& x) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return std::clamp(nearest_double(x), -kMost, kMost);
}

}  // namespace

ScaledPoint::ScaledPoint(const ExactPoint& p)
    : rounded{rounded_coordinate(p[0]), rounded_coordinate(p[1]), rounded_coordinate(p[2])} {
  const Integer &x = p[0].denominator(), &y = p[1].denominator(), &z = p[2].denominator();
  const auto all = [](const Integer& numerator, const Integer& a, const Integer& b) {
    return Dyadic(numerator * a * b);
  };
  at = {all(p[0].numerator(), y, z), all(p[1].numerator(), x, z), all(p[2].numerator(), x, y)};
  weight = Dyadic(x * y * z);
  const double most = std::max({std::abs(rounded.x), std::abs(rounded.y), std::abs(rounded.z)});
  slack = most * 0x1p-52 + 0x1p-1074;
}

Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const ScaledPoint& d) {
  const Dyadic ux = difference(b.x, a.x), uy = difference(b.y, a.y), uz = difference(b.z, a.z);
  const Dyadic vx = difference(c.x, a.x), vy = difference(c.y, a.y), vz = difference(c.z, a.z);
  return ((uy * vz - uz * vy) * d.beyond(0, a.x) + (uz * vx - ux * vz) * d.beyond(1, a.y) +
          (ux * vy - uy * vx) * d.beyond(2, a.z))
      .sign();
}

Sign orient2d(const Vec3d& a, const Vec3d& b, const ScaledPoint& c, int axis) {
  const int p = (axis + 1) % 3, q = (axis + 2) % 3;
  return (difference(b[p], a[p]) * c.beyond(static_cast<std::size_t>(q), a[q]) -
          difference(b[q], a[q]) * c.beyond(static_cast<std::size_t>(p), a[p]))
      .sign();
}

bool is_in(const Box3d& box, const ScaledPoint& q) {
  for (std::size_t k = 0; k < 3; ++k)
    if (q.compare(k, box.lo[k]) < 0 || q.compare(k, box.hi[k]) > 0) return false;
  return true;
}

}  // namespace veritope::internal
