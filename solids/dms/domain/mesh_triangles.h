// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/mesh_triangles.h: the triangles of a mesh with planes through their sides.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/sign.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// The mesh as the cutter sees it: the triangles, and for each side of each a plane through it that crosses the
/// triangle's plane.
class MeshTriangles {
 public:
  /// REQUIRES triangles that are not degenerate.
  explicit MeshTriangles(const TriangleMesh& mesh);

  std::size_t size() const { return mesh_.faces.size(); }
  const std::array<std::uint32_t, 3>& corners(std::uint32_t t) const { return mesh_.faces[t]; }
  const Vec3d& point(std::uint32_t t, std::size_t k) const {
    return mesh_.positions[mesh_.faces[t][k]];
  }
  /// A plane through corners k and k + 1.
  std::array<Vec3d, 3> rim(std::uint32_t t, std::size_t k) const {
    return {point(t, k), point(t, (k + 1) % 3), beside_[t]};
  }
  /// The side of rim(t, k) on which the triangle lies.
  Sign rim_side(std::uint32_t t, std::size_t k) const { return rim_sides_[t][k]; }
  /// A point off the triangle's plane.
  const Vec3d& beside(std::uint32_t t) const { return beside_[t]; }

 private:
  const TriangleMesh& mesh_;
  std::vector<Vec3d> beside_;
  std::vector<std::array<Sign, 3>> rim_sides_;
};

}  // namespace veritope
