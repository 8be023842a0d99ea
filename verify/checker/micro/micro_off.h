// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_off.h: I1, and points of the parts; docs/certificates/micro-inside.md, section 3.
#pragma once
#include "micro_maps.h"

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
// The halves of a net of parameters along the axis.
void halve_net(const DoubleNet& net, size_t axis, DoubleNet* lower, DoubleNet* upper);

// A patch of a tile lies in one box of knots. Where its box touches another one, the points there are among those here:
// the map is continuous, and its coefficients on a face are those of the face.
class OffSurface {
 public:
  OffSurface(const MicroFile& file, const Triangles& triangles, VolumeMaps* maps);
  void check_cells();    // I1 for tiles
  void check_bridges();  // I1 for bridges
  // A point that no triangle separates from S(0, 0) of a patch in a cell, after I1.
  void point_near(const PatchOfCell& patch, double* point);

 private:
  struct Block {  // cells of a grid, in one box of knots
    size_t lo[3], hi[3];
  };
  struct Interval {        // between two knots of an axis
    std::vector<Span> at;  // the breaks of a grid, where the interval is [0, 1]
    size_t first;          // the first one
  };
  struct GridBoxes {
    std::vector<Interval> axis[3];
  };
  struct Region {  // a box of knots
    const DoubleNet* net;
    const Interval* axis[3];
  };
  struct CellNet {  // of a cell, or a greater part of its box
    DoubleNet net;
    double slack[3];  // by which parameters of the cell may be moved in it
  };
  typedef std::vector<std::vector<DoubleNet>> Lists;  // of each patch of a tile

  void find_intervals(const MicroGrid& grid);
  void check_block(const MicroGrid& grid, const Region& region, const Block& block);
  void check_cell(const MicroGrid& grid, const size_t* i, const CellNet& cell);
  Region region_of(const MicroGrid& grid, const size_t* box) {
    const GridBoxes& b = boxes_[size_t(&grid - file_.grids.data())];
    return Region{&maps_.net(grid.volume, box),
                  {&b.axis[0][box[0]], &b.axis[1][box[1]], &b.axis[2][box[2]]}};
  }
  CellNet net_in(const Region& region, const Block& block) const;
  DoubleNet patch_in(const MicroGrid& grid, const size_t* i, size_t tile, size_t patch) const;
  // The points of a node of a patch.
  void set_points(const DoubleNet& node, const CellNet& cell, PointHull* hull);
  void add_nodes(uint64_t nodes) {
    nodes_ += nodes;
    require(nodes_ <= most_nodes_ && pairs_ <= kMostPairs, "I1",
            "this checker has a limit of nodes, and of their pairs with triangles; nodes:", nodes_);
  }

  static const uint64_t kMostPairs = 1 << 30;
  const MicroFile& file_;
  const Triangles& triangles_;
  VolumeMaps& maps_;
  std::vector<Lists> lists_;      // of each tile
  std::vector<GridBoxes> boxes_;  // of each grid
  uint64_t nodes_ = 0, pairs_ = 0, most_nodes_ = 0;
  DoubleNet scratch_;
};
