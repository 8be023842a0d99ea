// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/mesh_cells.h: tetrahedra cut along the triangles of a mesh, until each cell is inside or outside.
// Source: [DA21], re-derived.  Design: docs/design/0094-domains-of-meshes.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "solids/dms/domain/convex_cells.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// Cells, each inside or outside.
struct MeshCells {
  static constexpr std::uint32_t kOff = 0xffffffffu;
  ConvexCells cells;
  /// For each face that lies on the mesh a triangle with which it has inner points in common; kOff for the others.
  std::vector<std::uint32_t> triangle_at;
  std::vector<std::uint8_t> is_inside;  ///< for each cell
  std::uint64_t cuts = 0;
};

/// @param mesh        REQUIRES rules M1 to M9 and finite positions
/// @param tetrahedra  fill the convex hull of the positions; positively oriented, face to face
/// @error kOverLimit if more than max_vertices vertices arise
/// @cost  each triangle is tested with the parts of the tetrahedra near it
Result<MeshCells> cut_along_mesh(const TriangleMesh& mesh,
                                 std::span<const TetrahedronCorners> tetrahedra,
                                 std::size_t max_vertices);

}  // namespace veritope
