// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_patches.h: the patches of a spline model, as micro-inside-1 asks about them; docs/certificates/micro-inside.md,
// section 8.
#pragma once
#include "../points/patch_winding.h"
#include "micro_net.h"

class SplinePatches : public Obstacle {
 public:
  // The patches count in units of 2^unit.
  SplinePatches(const std::vector<Grid>& grids, const std::vector<bool>& is_rational, int64_t unit);
  bool has_patches() const override { return true; }
  bool misses(const PointHull& hull, uint64_t* pairs) override;
  bool misses_block(const PointHull& hull, uint64_t* pairs) override { return misses(hull, pairs); }
  bool is_near(const PointHull& hull, double distance, uint64_t* pairs) override;

 private:
  // With base for the first of the points, the values of N.(q - base), N the vector of step 3, are between least and
  // most for all of the node's points q. Each number of n differs by at most error from N's.
  struct Node {
    DoubleNet net;
    PointHull hull;
    int level;
    uint32_t child;  // the lower half; 0: not made yet
    double n[3], error, least, most;
  };
  Node make(DoubleNet net, int level) const;
  uint32_t children(uint32_t node);
  // The nodes of some patch that are kept are few enough to go on with; otherwise they are dropped.
  void tidy();
  std::vector<uint32_t> roots_near(const DoubleBox& box) const;

  std::vector<Node> nodes_;  // first those of whole patches
  size_t numbers_ = 0;       // of the nodes that are no whole patches
  size_t patches_ = 0;
  std::unique_ptr<const BoxTree> tree_;
};
