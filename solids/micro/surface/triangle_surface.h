// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/surface/triangle_surface.h: a mesh as the surface of a solid, with the directions in which a certificate
// may show that points are apart from its triangles.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "predicates/vec.h"
#include "solids/base/box_hierarchy.h"
#include "solids/micro/surface/solid_surface.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

class TriangleSurface final : public SolidSurface {
 public:
  /// REQUIRES finite coordinates. The mesh must outlive it.
  explicit TriangleSurface(const TriangleMesh& mesh);
  explicit TriangleSurface(TriangleMesh&&) = delete;

  /// Parts are the triangles, by their numbers.
  std::unique_ptr<SurfaceView> view() const override;
  const Box3d& box() const override { return box_; }

  /// True only if all points lie strictly on one side of the triangle along one of the seven directions of the page:
  /// an axis, the triangle's normal, or a normal of a side in its plane. REQUIRES a live ScopedUpward.
  bool is_apart(std::uint32_t facet, const NodePoints& points) const;
  const Box3d& box(std::uint32_t facet) const { return boxes_[facet]; }
  std::array<Vec3d, 3> corners(std::uint32_t facet) const {
    const auto& t = mesh_->faces[facet];
    return {mesh_->positions[t[0]], mesh_->positions[t[1]], mesh_->positions[t[2]]};
  }

  /// Calls visit(facet) for every facet whose box meets the box.
  template <typename Visit>
  void visit(const Box3d& box, Visit visit) const {
    tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }

 private:
  const TriangleMesh* mesh_;
  Box3d box_ = empty_box();
  std::vector<Box3d> boxes_;
  std::vector<std::array<Slab, 4>> slabs_;
  BoxHierarchy tree_;
};

}  // namespace veritope
