// SPDX-License-Identifier: LGPL-3.0-or-later
// hard_models/hard_mesh.h: meshes that are hard to decide, whose answers are known by construction.
// tests/cli/hard_models_test.py decides each of them a second time, in Python's fractions.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "solids/polyhedron/rules.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::hard_models {

/// A mesh and its answer. Vertices are distinct positions, so that its file has the same answer with and without
/// merging them.
struct HardMesh {
  std::string name;  ///< letters, digits and underscores
  std::string what;  ///< one sentence
  TriangleMesh mesh;
  /// The number of places where each rule is broken; all zero iff the mesh is valid. The numbers of M8 and M9 are 0
  /// where M1 to M7 do not all hold.
  std::array<int, kNumMeshRules> breaks{};
  int bodies = 0, genus = 0;  ///< of a valid mesh
};

bool is_valid(const HardMesh& model);

/// The smallest violation of each rule and its nearest valid neighbour; cracks of one ulp; vertices, edges and walls
/// that are apart, touch or cross by one ulp; nested shells with right and wrong sides; thin walls; needles; copies.
std::vector<HardMesh> plain_hard_meshes();

/// Those of plain_hard_meshes(), and images of each with the same answer, as far as binary64 holds their coordinates:
/// NAME_huge and NAME_tiny, scaled by powers of two to the ends of binary64; NAME_oblique, turned;
/// NAME_shuffled, whose vertices, faces and corners are in another order, which `seed` selects.
std::vector<HardMesh> hard_meshes(std::uint64_t seed);

}  // namespace veritope::hard_models
