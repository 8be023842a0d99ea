// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/cell_plans_internal.h: which vertices and facets of a tile's mesh a cell makes. Cells of one tile
// mostly have one plan. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "solids/micro/mesh/cap_links_internal.h"
#include "solids/micro/mesh/tile_mesh_internal.h"

namespace veritope::internal {

/// Numbers begin, ..., end - 1.
using PlanRange = std::array<std::uint32_t, 2>;

struct CellPlan {
  std::vector<PlanRange> own;      ///< vertices that the cell makes, in their order
  std::vector<PlanRange> present;  ///< those and the ones on rims of other cells
  std::vector<std::uint32_t>
      first_of_group;  ///< of the cell's own groups: which of its vertices is the first
  std::vector<PlanRange> triangles, quads;  ///< of patches that are not dropped
  std::vector<std::uint32_t> patches;       ///< those
  std::uint32_t num_vertices = 0, num_triangles = 0;
};

/// Does the cell make the vertices of this group, TileMesh::group_begin?
bool is_own_group(const LinkedCell& cell, std::size_t group);

class CellPlans {
 public:
  /// The number of the plan. REQUIRES a mesh that stays until clear().
  std::uint32_t number_of(const AnalysedTile& tile, const TileMesh& mesh, const LinkedCell& cell);
  const CellPlan& operator[](std::uint32_t number) const { return plans_[number]; }
  void clear();

 private:
  struct Key {
    const TileMesh* mesh = nullptr;
    std::uint64_t dropped = 0, borrowed = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& k) const;
  };
  std::unordered_map<Key, std::uint32_t, Hash> numbers_;
  std::vector<CellPlan> plans_;
  Key last_key_;  // of the last call, and its answer
  std::uint32_t last_ = 0;
};

}  // namespace veritope::internal
