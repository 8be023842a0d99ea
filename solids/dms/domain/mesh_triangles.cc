// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/mesh_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "predicates/orient3d.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

double& coordinate(Vec3d& p, int axis) { return axis == 0 ? p.x : (axis == 1 ? p.y : p.z); }

// A point that differs from `a` on one axis and lies off the plane of a, b, c; nothing if the plane is parallel to it.
std::optional<Vec3d> point_along(const Vec3d& a, const Vec3d& b, const Vec3d& c, int axis,
                                 double step) {
  Vec3d p = a;
  for (; p[axis] == a[axis]; step *= 2)
    coordinate(p, axis) = a[axis] < 0 ? a[axis] + step : a[axis] - step;
  if (orient3d(a, b, c, p) == Sign::kZero) return std::nullopt;
  return p;
}

// A corner moved along the axis that the normal is nearest to.
Vec3d point_beside(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  double step = 0;
  for (int k = 0; k < 3; ++k)
    step = std::max({step, std::abs(b[k] / 2 - a[k] / 2), std::abs(c[k] / 2 - a[k] / 2)});
  step = std::max(step, std::numeric_limits<double>::min());
  std::array<double, 3> normal{};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const auto u = [&](const Vec3d& p, int axis) { return (p[axis] / 2 - a[axis] / 2) / step; };
    normal[static_cast<std::size_t>(k)] = std::abs(u(b, i) * u(c, j) - u(b, j) * u(c, i));
  }
  const auto first =
      static_cast<int>(std::max_element(normal.begin(), normal.end()) - normal.begin());
  for (int turn = 0; turn < 3; ++turn)
    if (const auto p = point_along(a, b, c, (first + turn) % 3, step)) return *p;
  VT_CHECK(false, "an axis leaves the plane of a triangle that is not degenerate");
  return a;
}

}  // namespace

MeshTriangles::MeshTriangles(const TriangleMesh& mesh) : mesh_(mesh) {
  for (std::uint32_t t = 0; t < size(); ++t) {
    beside_.push_back(point_beside(point(t, 0), point(t, 1), point(t, 2)));
    std::array<Sign, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto plane = rim(t, k);
      sides[k] = orient3d(plane[0], plane[1], plane[2], point(t, (k + 2) % 3));
    }
    rim_sides_.push_back(sides);
  }
}

}  // namespace veritope
