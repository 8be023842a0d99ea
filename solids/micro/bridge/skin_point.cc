// SPDX-License-Identifier: LGPL-3.0-or-later
#include <array>

#include "solids/micro/bridge/skin_point_internal.h"

namespace veritope::internal {
namespace {

ExactPoint exact_point(const Point3d& p) {
  return {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])};
}

}  // namespace

SkinPoint MeshSkin::nearest(const Point3d& p) const {
  const MeshProjectionAnswer answer = projection_.project(exact_point(p));
  const NearestPoint& nearest = answer.nearest.front();
  const auto& face = mesh_.faces[nearest.facet];
  std::array<Point3d, 3> q;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& x = mesh_.positions[face[i]];
    q[i] = {x.x, x.y, x.z};
  }
  SkinPoint out{{nearest_double(nearest.point[0]), nearest_double(nearest.point[1]),
                 nearest_double(nearest.point[2])},
                unit_vector(cross_product(sum_of(q[1], -1, q[0]), sum_of(q[2], -1, q[0])))};
  const Point3d way = sum_of(p, -1, out.at);
  if (nearest.feature == MeshFeature::kFacet || !(size_of(way) > 0)) return out;
  const double side = dot_product(out.normal, way);
  out.normal = unit_vector(way);
  if (side < 0)
    for (double& x : out.normal) x = -x;
  return out;
}

double MeshSkin::distance(const Point3d& p) const {
  return std::sqrt(nearest_double(projection_.project(exact_point(p)).squared_distance));
}

double MeshSkin::depth(const Point3d& p) const {
  const SkinPoint at = nearest(p);
  return -dot_product(at.normal, sum_of(p, -1, at.at));
}

}  // namespace veritope::internal
