// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_parts.h: patches of tiles, cells and sweeps as nets with bounds of their errors, and their points;
// docs/certificates/micro-inside.md, section 3, and microstructure.md, section 7b.
#pragma once
#include "micro_maps.h"

struct CellBlock {  // cells of a grid, in one box of knots
  size_t lo[3], hi[3];

  bool is_cell() const { return hi[0] - lo[0] == 1 && hi[1] - lo[1] == 1 && hi[2] - lo[2] == 1; }
  // The halves of a block of several cells along its longest axis.
  std::pair<CellBlock, CellBlock> halves() const;
};
// Whether one of the cells holds a tile.
bool holds_tile(const MicroGrid& g, const CellBlock& block);

struct CellNet {  // the map on a cell, a block or a greater part of its box of knots
  DoubleNet net;
  double slack[3];  // by which parameters of the cell may be moved in it
};

// A patch of a tile lies in one box of knots. Where its box touches another one, the points there are among those here:
// the map is continuous, and its coefficients on a face are those of the face.
class TileParts {
 public:
  TileParts(const MicroFile& file, VolumeMaps* maps);

  const MicroFile& file() const { return file_; }
  VolumeMaps& maps() const { return maps_; }
  // Parts: patches in all cells, bridges and sweeps.
  uint64_t count() const { return count_; }
  // Calls use(box of knots, its block) for each of the grid in which a cell holds a tile.
  void each_box(const MicroGrid& g,
                const std::function<void(const size_t*, const CellBlock&)>& use) const;
  // The box of knots that holds cell i.
  void box_of_cell(const MicroGrid& g, const size_t* i, size_t* box) const;
  CellBlock block_of_box(const MicroGrid& g, const size_t* box) const;

  // Break i of the grid along an axis, in the parameters where the box of knots is [0, 1].
  const Span& break_in(const MicroGrid& g, const size_t* box, size_t axis, size_t i) const {
    const Interval& all = boxes_of(g).axis[axis][box[axis]];
    return all.at[i - all.first];
  }
  CellNet net_in(const MicroGrid& g, const size_t* box, const CellBlock& block) const;
  CellNet net_of_cell(const MicroGrid& g, const size_t* i) const;
  DoubleNet patch_in(const MicroGrid& g, const size_t* i, size_t tile, size_t patch) const;
  // The points of a node of a patch with this net.
  void set_points(const DoubleNet& node, const CellNet& cell, PointHull* hull);

 private:
  struct Interval {        // between two knots of an axis
    std::vector<Span> at;  // the breaks of a grid, where the interval is [0, 1]
    size_t first;          // the first one
  };
  struct GridBoxes {
    std::vector<Interval> axis[3];
  };
  typedef std::vector<std::vector<DoubleNet>> Lists;  // of each patch of a tile

  void find_intervals(const MicroGrid& grid);
  const GridBoxes& boxes_of(const MicroGrid& g) const {
    return boxes_[size_t(&g - file_.grids.data())];
  }

  const MicroFile& file_;
  VolumeMaps& maps_;
  std::vector<Lists> lists_;      // of each tile
  std::vector<GridBoxes> boxes_;  // of each grid
  uint64_t count_ = 0;
  DoubleNet scratch_;
};

// A sweep in its cell.
class SweepPart {
 public:
  SweepPart(TileParts* parts, const MicroSweep& sweep, uint64_t number, const char* id);

  const MicroSweep& sweep() const { return sweep_; }
  const CellNet& cell() const { return cell_; }
  const DoubleNet& cap() const { return cap_; }  // in the cell's unit cube
  // The points of a node: P has this net; its interval of w lies from lo to hi, multiples of 2^-25.
  void set_points(const DoubleNet& cap, double lo, double hi, PointHull* hull) const;

 private:
  TileParts& parts_;
  const MicroSweep& sweep_;
  CellNet cell_;
  DoubleNet cap_;
};
