// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/plain_vectors_internal.h: vectors in floating point, from which bridges are proposed. Internal to
// solids/micro/bridge.
#pragma once
#include <cmath>
#include <cstddef>

#include "robust/base/box3d.h"

namespace veritope::internal {

// a + k b.
inline Point3d sum_of(const Point3d& a, double k, const Point3d& b) {
  return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
}
inline double dot_product(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double size_of(const Point3d& a) { return std::sqrt(dot_product(a, a)); }
inline Point3d cross_product(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point3d unit_vector(const Point3d& a) {
  const double n = size_of(a);
  return {a[0] / n, a[1] / n, a[2] / n};
}

}  // namespace veritope::internal
