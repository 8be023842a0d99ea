// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "render/flat_scene_internal.h"

namespace veritope::internal {

// The light comes over the camera's left shoulder, so that faces at equal angles to the camera differ. A face that is
// seen has a cosine of at least kLeastCosine to the light, up to perspective, and gets from kAmbient to all of it.
double light_of(const Point3d& normal) {
  constexpr Point3d kLight = {-2.0 / 7, 3.0 / 7, 6.0 / 7};  // a unit vector
  constexpr double kAmbient = 0.3, kLeastCosine = -0.515;   // -sqrt(1 - (6/7)^2)
  const double cosine = normal[0] * kLight[0] + normal[1] * kLight[1] + normal[2] * kLight[2];
  const double share = std::clamp((cosine - kLeastCosine) / (1 - kLeastCosine), 0.0, 1.0);
  return kAmbient + (1 - kAmbient) * share;
}

FacetView facet_view(const std::array<Point3d, 3>& corners, double distance) {
  constexpr double kTiny =
      0x1p-500;  // A normal that is longer has squares that have not underflowed.
  const auto& [a, b, c] = corners;
  const Point3d u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  Point3d n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > kTiny)) return {};
  const bool is_back = n[2] * (distance - a[2]) < n[0] * a[0] + n[1] * a[1];
  if (is_back) length = -length;
  for (double& x : n) x /= length;
  const auto rounded = [](double x) { return static_cast<std::int8_t>(std::floor(127 * x + 0.5)); };
  return {light_of(n), {rounded(n[0]), rounded(n[1]), rounded(n[2])}};
}

}  // namespace veritope::internal
