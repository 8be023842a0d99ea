// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/skin_projection_internal.h: the points of a solid's surface that are nearest to a point, as
// bridges ask for them. Internal to solids/micro/bridge.
#pragma once
#include <memory>

#include "interval/interval.h"
#include "robust/base/box3d.h"
#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::internal {

/// An approximate point of the surface, and the normal there, outward.
struct SkinPoint {
  Point3d at{}, normal{};
};

/// Immutable: threads share it.
class SkinProjection {
 public:
  virtual ~SkinProjection() = default;
  /// One of the nearest points, always the same. Where the surface has an edge or a vertex there, the normal is along
  /// the line to the point.
  virtual SkinPoint project(const Point3d& p) const = 0;
  /// Contains the square of the distance of a point.
  virtual Interval squared_distance(const ExactPoint& p) const = 0;
};

/// REQUIRES a mesh that bounds a solid. The mesh must outlive it.
std::unique_ptr<const SkinProjection> skin_projection(const TriangleMesh& mesh);
/// REQUIRES a complex that bounds a solid. It must outlive it.
std::unique_ptr<const SkinProjection> skin_projection(const PatchComplex& complex);

/// Approximate: the distance from the surface; the same, negative outside of the solid, as the nearest point tells.
double approx_distance(const SkinProjection& skin, const Point3d& p);
double approx_depth(const SkinProjection& skin, const Point3d& p);

/// Exactly. REQUIRES finite coordinates.
ExactPoint exact_point(const Point3d& p);

}  // namespace veritope::internal
