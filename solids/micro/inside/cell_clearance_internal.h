// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/cell_clearance_internal.h: how far the tile of one cell is from a surface. Internal to
// solids/micro/inside.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/micro/inside/clearance.h"
#include "solids/micro/inside/enclosed_patch_internal.h"
#include "solids/micro/inside/part_net_internal.h"
#include "solids/micro/inside/surface_parts_internal.h"

namespace veritope::internal {

/// A bound is not improved if it is this near to an attained distance.
inline constexpr double kEnoughClearance = 1 + 0x1p-7;

/// The patches of a kind of tile, in a tree of boxes in [0,1]^3 that hold them for all numbers of walls. All functions
/// REQUIRE a live ScopedUpward.
class PatchTree {
 public:
  explicit PatchTree(const MicroTile& tile);

  struct Node {
    Box3 box;
    std::uint32_t patch = 0;              ///< of a leaf
    std::array<std::uint32_t, 2> next{};  ///< both parts; 0: a leaf
    bool is_leaf() const { return next[0] == 0; }
  };
  /// The root is the first one. REQUIRES that the tile has a patch.
  const Node& node(std::uint32_t number) const { return nodes_[number]; }
  const EnclosedPatch& patch(std::uint32_t number) const { return patches_[number]; }
  const std::vector<EnclosedPatch>& patches() const { return patches_; }

 private:
  std::uint32_t make(std::vector<std::uint32_t>& order, std::size_t begin, std::size_t end,
                     const std::vector<Box3>& boxes);

  std::vector<EnclosedPatch> patches_;
  std::vector<Node> nodes_;
};

/// What is known of one cell: lo <= the distance of its tile. hi is attained, perhaps in another cell.
struct CellClearance {
  double lo = 0, hi = 0;
  std::uint64_t nodes = 0;
  bool is_bounded = true;  ///< false: numbers are not finite, or a weight may be 0
};

/// @param net    the map of the cell, on [0,1]^3
/// @param known  an attained distance, or infinity
/// Returns lo >= hi / kEnoughClearance unless it takes too many nodes. REQUIRES a live ScopedUpward.
CellClearance clearance_of_cell(const PartNet& net, const PatchTree& tile,
                                const WallNumbers& numbers, const DistanceParts& surface,
                                double known, std::uint64_t most_nodes);

}  // namespace veritope::internal
