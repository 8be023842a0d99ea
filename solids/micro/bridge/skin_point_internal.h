// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/skin_point_internal.h: the nearest point of a mesh's surface, approximately, and vectors.
// Internal to solids/micro/bridge.
#pragma once
#include <cmath>

#include "robust/base/box3d.h"
#include "solids/classify/mesh_projection.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::internal {

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

/// An approximate point of the surface, and the normal there, outward.
struct SkinPoint {
  Point3d at{}, normal{};
};

/// The mesh must outlive it. Immutable: threads may share it.
class MeshSkin {
 public:
  explicit MeshSkin(const TriangleMesh& mesh) : mesh_(mesh), projection_(mesh) {}

  const MeshProjection& projection() const { return projection_; }
  SkinPoint nearest(const Point3d& p) const;
  double distance(const Point3d& p) const;
  /// The distance from the surface; negative outside of the solid, as the nearest facet tells.
  double depth(const Point3d& p) const;

 private:
  const TriangleMesh& mesh_;
  MeshProjection projection_;
};

}  // namespace veritope::internal
