// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/micro_mesh.h: one watertight triangle mesh of a microstructure, at a proved distance from it.
// Design: docs/design/0075-meshes-of-microstructures.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"
#include "solids/micro/tile_analysis.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// decide_validity takes meshes with fewer facets.
inline constexpr std::uint64_t kMaxMicroFacets = (std::uint64_t{1} << 30) - 1;

struct MicroMeshOptions {
  double chord = 0;   ///< how far mesh and surface may be apart, in units of the model; > 0
  unsigned jobs = 1;  ///< threads; the mesh is the same for every number
  std::uint64_t max_facets = kMaxMicroFacets;
};

/// Into how many parts along u and along v the patches of a tile are cut, in all cells of a block of a grid.
struct MicroMeshParts {
  std::uint32_t grid = 0, tile = 0;
  /// Along each axis of the grid: the first cell of the block, and one past the last.
  std::array<std::array<std::size_t, 2>, 3> block{};
  std::vector<std::array<std::uint32_t, 2>> of_patch;
};

struct MicroMesh {
  /// Facets turn outward.
  TriangleMesh mesh;
  /// Between the surface and the mesh there is a continuous map of each patch onto its triangles that moves no
  /// point by more than this: neither has a point farther from the other. In units of the model, rounded upward.
  double distance = 0;
  /// No vertex is farther from the point of the surface that it stands for.
  double rounding = 0;
  std::vector<MicroMeshParts> parts;
};

/// The surface of the union of all mapped tiles: their patches but for those of equal caps, each cut into
/// triangles. Equal sides of patches, also of different cells, have common vertices, so the mesh is a closed
/// surface with the shells and the genus of the structure, at any chord. Whether it is embedded is not decided
/// here (decide_validity does it): with a large chord it may cross itself.
/// REQUIRES that the cage is that of micro, the analysed tiles are its tiles, each with at most 64 caps, that
/// topology_of finds no defect, and that determinants of the cage have one sign in each volume.
/// @error kBadArgument: a chord that is not positive and finite, or less than 64 times the rounding of vertices;
///        what topology_of refuses. kEmpty: no cell holds a tile. kOverLimit: more than max_facets facets.
///        kNotFinite: control points near the end of the range of binary64
/// @cost  near-linear in the facets: approximately 25 ns for each; 24 bytes a facet in the result
Result<MicroMesh> mesh_of(const Microstructure& micro, const VModel& cage,
                          const std::vector<AnalysedTile>& tiles, const MicroMeshOptions& options);

}  // namespace veritope
