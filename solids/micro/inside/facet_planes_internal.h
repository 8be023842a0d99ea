// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/facet_planes_internal.h: the triangles of a mesh with the directions in which a certificate may
// show that points are apart from them. Internal to solids/micro/inside.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "predicates/vec.h"
#include "solids/base/box_hierarchy.h"
#include "solids/micro/inside/part_net_internal.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::internal {

/// A bound of |fl(d.m) - d.q| for the middles m of the points q, where fl(d.m) is the plain sum of three products; not
/// finite if that may overflow. REQUIRES a live ScopedUpward.
double dot_slack(const Point3d& d, const NodePoints& points);

/// Immutable: threads may share it.
class FacetPlanes {
 public:
  /// REQUIRES finite coordinates. The mesh must outlive it.
  explicit FacetPlanes(const TriangleMesh& mesh);

  /// True only if all points lie strictly on one side of the triangle along one of the seven directions of the page:
  /// an axis, the triangle's normal, or a normal of a side in its plane. REQUIRES a live ScopedUpward.
  bool is_apart(std::uint32_t facet, const NodePoints& points) const;
  const Box3d& box(std::uint32_t facet) const { return boxes_[facet]; }
  std::array<Vec3d, 3> corners(std::uint32_t facet) const {
    const auto& t = mesh_->faces[facet];
    return {mesh_->positions[t[0]], mesh_->positions[t[1]], mesh_->positions[t[2]]};
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(boxes_.size()); }

  /// Calls visit(facet) for every facet whose box meets the box.
  template <typename Visit>
  void visit(const Box3d& box, Visit visit) const {
    tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }

 private:
  /// A direction, rounded, with bounds of its products with the corners.
  struct Slab {
    Point3d direction{};
    double lo = 0, hi = 0;
  };
  const TriangleMesh* mesh_;
  std::vector<Box3d> boxes_;
  std::vector<std::array<Slab, 4>> slabs_;
  BoxHierarchy tree_;
};

}  // namespace veritope::internal
