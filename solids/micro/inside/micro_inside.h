// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/micro_inside.h: proves that a microstructure lies in the interior of a solid that a mesh, or a
// complex of patches, bounds. The conditions I1 to I4 of docs/certificates/micro-inside.md. Theory: docs/THEORY.md,
// MICRO-2. Design: docs/design/0080-microstructures-inside-solids.md and 0089-microstructures-in-solids-of-patches.md.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solids/classify/mesh_classifier.h"
#include "solids/micro/micro_topology.h"
#include "solids/patches/patch_complex.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// A point behind the surface of a void of the solid that is not in the microstructure.
struct VoidPoint {
  std::uint32_t volume = 0;
  TilePoint x;  ///< in the parameters of the volume
  std::uint8_t corner =
      8;  ///< that corner of its cell to which a box without tile leads; 8: its cell holds no tile
};

struct InsideProof {
  std::vector<VoidPoint> voids;  ///< of the solid, by the numbers of their shells
  /// No end face of a bridge is farther from the solid's surface; nothing if there are no bridges.
  std::optional<Rational> skin;
};

/// The first condition that is not proved to hold. Nothing says that it does not hold, unless the message does.
struct InsideDefect {
  const char* condition = "";           ///< "I1" to "I4"
  std::optional<CellPatch> patch;       ///< of a tile
  std::optional<std::uint32_t> bridge;  ///< its number
  std::optional<std::uint32_t> source;  ///< the triangle or the patch of the solid
  std::string message;
};

/// The mesh of a solid with its shells. The mesh must outlive it.
struct InsideModel {
  const TriangleMesh* mesh = nullptr;
  MeshShells shells;
};

/// What a proof may cost: half of what the page lets a checker spend, since a checker may bound numbers less closely.
struct InsideLimits {
  std::uint64_t nodes = std::uint64_t{1} << 21;  ///< of descents of I1
  std::uint64_t nodes_of_part = 32;  ///< more nodes for each patch in a cell and each bridge
  std::uint64_t pairs = std::uint64_t{1}
                        << 29;  ///< of nodes and triangles, or nodes of patches, whose boxes meet
};

/// The proof, or what is missing for it; both are the same for every number of jobs.
/// REQUIRES that topology_of accepts the microstructure with these tiles, and said these first patches; a mesh that
/// bounds a solid, with fewer than 2^30 faces; bridges as the page of microstructures demands.
/// @cost  near-linear in the facets, 600 bytes each; in the cells near the mesh, a few microseconds a patch
std::variant<InsideProof, InsideDefect> prove_inside(const Microstructure& micro,
                                                     const std::vector<AnalysedTile>& tiles,
                                                     const std::vector<CellPatch>& first_patches,
                                                     const InsideModel& model, unsigned jobs,
                                                     const InsideLimits& limits = {});
/// For a complex that bounds a solid.
/// @cost  near-linear in the patches; in the cells near them, some ten microseconds a patch
std::variant<InsideProof, InsideDefect> prove_inside(const Microstructure& micro,
                                                     const std::vector<AnalysedTile>& tiles,
                                                     const std::vector<CellPatch>& first_patches,
                                                     const PatchComplex& model, unsigned jobs,
                                                     const InsideLimits& limits = {});

}  // namespace veritope
