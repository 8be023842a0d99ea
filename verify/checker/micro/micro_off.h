// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_off.h: I1, and points of the parts; docs/certificates/micro-inside.md, section 3.
#pragma once
#include <set>

#include "micro_parts.h"

// The boxes of a volume that one of parameters meets, and its part in each. Parameters are those where the domain is
// [0, 1].
class KnotBoxes {
 public:
  KnotBoxes(VolumeMaps* maps, uint64_t volume) : maps_(*maps), volume_(volume) {}
  // Calls use(hull) with the points in each of the boxes, until it is false; then the result is false. *count: of them.
  bool each(const DoubleBox& x, uint64_t* count, const std::function<bool(const PointHull&)>& use);

 private:
  VolumeMaps& maps_;
  const uint64_t volume_;
};
// The parameters of a bridge where the domain of its volume is [0, 1]: all lists, or list 2 only.
DoubleNet net_of_bridge(const MicroBridge& bridge, const Entity& volume, bool is_end_only);

class OffSurface {
 public:
  OffSurface(TileParts* parts, Obstacle* surface);
  void check_cells();    // I1 for tiles
  void check_bridges();  // I1 for bridges
  void check_sweeps();   // I1 for sweeps

  // After I1: points that nothing separates from S(0, 0) of a patch in a cell.
  void point_near(const PatchOfCell& patch, PointHull* hull);
  typedef std::array<uint32_t, 7> BlockKey;
  // False if no block of cells was passed over that holds the cell; otherwise the points of the block, and what it is
  // known by. REQUIRES that the surface has patches.
  bool point_of_block(const PatchOfCell& patch, BlockKey* key, PointHull* hull) const;

 private:
  void check_block(const MicroGrid& grid, const size_t* box, const CellBlock& block);
  void check_cell(const MicroGrid& grid, const size_t* i, const CellNet& cell);
  BlockKey key_of(const MicroGrid& g, const CellBlock& block) const;
  // For triangles there are limits of nodes and of pairs; for patches both together are one of pairs.
  void add_nodes(uint64_t nodes) {
    nodes_ += nodes;
    const bool has_patches = surface_.has_patches();
    require((has_patches || nodes_ <= most_nodes_) &&
                pairs_ <= kMostPairs + (has_patches ? most_nodes_ : 0),
            "I1", "this checker has a limit of nodes, and of their pairs; nodes:", nodes_);
  }

  const MicroFile& file_;
  TileParts& parts_;
  Obstacle& surface_;
  uint64_t nodes_ = 0, pairs_ = 0;
  const uint64_t most_nodes_;
  std::set<BlockKey> passed_;
};
