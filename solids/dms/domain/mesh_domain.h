// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/mesh_domain.h: a domain of tetrahedra whose boundary is a given mesh, exactly.
// Source: [DA21], re-derived.  Design: docs/design/0094-domains-of-meshes.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "robust/base/result.h"
#include "solids/dms/dms_model.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

struct MeshDomainOptions {
  std::size_t max_vertices = 1'000'000;  ///< of the cells, outside of the mesh, too
};

struct MeshDomain {
  /// Its degree is 1, its map the identity. The first vertices are the positions that triangles use, in their order.
  DmsModel model;
  std::size_t from_mesh = 0;        ///< vertices of the mesh
  std::size_t steiner_on_mesh = 0;  ///< vertices on the mesh that are no vertices of it
  std::size_t steiner_inside = 0;   ///< vertices off the mesh
  std::uint64_t cuts = 0;           ///< of cells by planes of triangles
  std::size_t cells = 0;            ///< convex ones inside of the mesh
};

/// Tetrahedra that fill a solid. Each has d > 0; the faces of one tetrahedron only are the mesh's triangles as a set of
/// points, with their orientation: triangles are subdivided, and coplanar neighbours may be subdivided together. So
/// the volume is the mesh's. Vertices on the mesh are exact; those inside of cells are short numbers where that is
/// possible.
/// @param mesh  REQUIRES rules M1 to M9 of docs/certificates/mesh.md
/// @error kOverLimit: more vertices than the options allow, or numbers of more than kMaxDmsBits bits
/// @cost  near-linear on meshes whose triangles are mostly faces of the positions' Delaunay tetrahedra; see the design
///        note
Result<MeshDomain> domain_of_mesh(const TriangleMesh& mesh, const MeshDomainOptions& options);

/// With other tetrahedra than those of Delaunay: positively oriented ones, face to face, whose corners are positions,
/// and that fill the convex hull of all positions. REQUIRES that triangles use every position.
Result<MeshDomain> domain_of_mesh(const TriangleMesh& mesh,
                                  std::span<const TetrahedronCorners> tetrahedra,
                                  const MeshDomainOptions& options);

}  // namespace veritope
