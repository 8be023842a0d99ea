// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_boxes.h: which patches a ray may meet, by a tree of boxes in rounded coordinates.
#pragma once
#include <array>

#include "patch_grid.h"

class PatchBoxes {
 public:
  explicit PatchBoxes(const std::vector<Grid>& grids);
  // All patches that are not missed by step 1 or 2 of the page, and maybe others.
  std::vector<uint32_t> on_ray(const RationalPoint& point, int direction) const;

 private:
  struct Box {
    int64_t lo[3], hi[3];
  };
  Box rounded(const Grid& grid) const;
  void floor_and_ceiling(const Big& n, const Big& d, int64_t* floor, int64_t* ceiling) const;
  void split(size_t node, size_t lo, size_t hi);

  int64_t scale_;  // coordinates count 2^-scale
  std::vector<Box> boxes_;
  std::vector<uint32_t> order_;
  std::vector<Box>
      nodes_;  // the children of node i are 2 i + 1 and 2 i + 2, each with a half of its patches
};
