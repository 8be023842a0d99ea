// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_ray_grid.h"

#include <cmath>

#include "solids/dms/dms_knots.h"

namespace veritope {
namespace {

DmsPoint exact(const Point3d& p) {
  return {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])};
}

}  // namespace

DmsLine DmsRayGrid::ray(std::size_t i, std::size_t j) const {
  DmsLine line{exact(origin), {}};
  const DmsPoint x = exact(right), y = exact(down), d = exact(along);
  const Rational column(i), row(j);
  for (std::size_t c = 0; c < 3; ++c) {
    line.from[c] += column * x[c] + row * y[c];
    line.to[c] = line.from[c] + d[c];
  }
  return line;
}

bool DmsRayGrid::is_sound() const {
  if (columns < 1 || columns > kMaxSide || rows < 1 || rows > kMaxSide) return false;
  for (const Point3d* p : {&origin, &right, &down, &along})
    for (const double x : *p)
      if (!std::isfinite(x)) return false;
  return dot_product(cross_product(exact(right), exact(down)), exact(along)).sign() != Sign::kZero;
}

}  // namespace veritope
