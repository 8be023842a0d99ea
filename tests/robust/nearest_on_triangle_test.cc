// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/robust/nearest_on_triangle_test.cc: the nearest point lies on the triangle, and no point of a grid on it is
// nearer.
#include "robust/base/nearest_on_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robust/base/random.h"

namespace veritope {
namespace {

double distance(const Point3d& a, const Point3d& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST(NearestOnTriangle, NoPointOfAGridIsNearer) {
  Random random(11);
  const auto drawn = [&] {
    Point3d p;
    for (double& x : p) x = static_cast<double>(random.between(-100, 100)) / 16;
    return p;
  };
  for (int i = 0; i < 500; ++i) {
    const Point3d a = drawn(), b = drawn(), c = drawn(), p = drawn();
    const Point3d found = approx_nearest_on_triangle(p, a, b, c);
    if (std::isnan(found[0])) continue;  // three points on one line
    double nearest = 1e300, from_grid = 1e300;
    for (int j = 0; j <= 40; ++j)
      for (int k = 0; j + k <= 40; ++k) {
        Point3d q;
        for (std::size_t x = 0; x < 3; ++x)
          q[x] = a[x] + j / 40.0 * (b[x] - a[x]) + k / 40.0 * (c[x] - a[x]);
        nearest = std::min(nearest, distance(p, q));
        from_grid = std::min(from_grid, distance(found, q));
      }
    const double side = std::max({distance(a, b), distance(b, c), distance(c, a)});
    EXPECT_LE(distance(p, found), nearest + 1e-9) << i;
    EXPECT_LE(from_grid, side / 40) << i;
  }
}

}  // namespace
}  // namespace veritope
