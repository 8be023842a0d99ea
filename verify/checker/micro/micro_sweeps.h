// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_sweeps.h: what the conditions of sweeps share; docs/certificates/microstructure.md, section 7b.
#pragma once
#include "micro_parts.h"

// Q2 for the sweep with this number. *work: products of numbers, of all sweeps.
void check_growth(TileParts* parts, const MicroSweep& sweep, uint64_t number, uint64_t* work);

// A tree of blocks of cells, whose nodes are made when they are needed.
class BlockTree {
 public:
  explicit BlockTree(TileParts* parts);
  // Calls use(grid, box of knots, cell, its map) for each cell that holds a tile and whose points may be in the box.
  // count() is called for each block of which that is so.
  void each_cell(const DoubleBox& box, const std::function<void()>& count,
                 const std::function<void(const MicroGrid&, const size_t*, const CellNet&)>& use);

 private:
  struct Node {
    uint32_t grid, knots[3];
    CellBlock block;
    DoubleBox box;           // contains the block's points
    uint32_t number, child;  // of the node and of its first half in nodes_, if they are there
    bool is_held;            // a cell holds a tile
  };
  Node make(uint32_t grid, const uint32_t* knots, const CellBlock& block);
  std::pair<Node, Node> halves(const Node& node);

  TileParts& parts_;
  std::vector<Node> nodes_;  // first those of boxes of knots; not too many
  size_t roots_ = 0;
  std::unique_ptr<const BoxTree> tree_;
};

struct PairNode;  // of a patch in a cell, or of a sweep
typedef std::shared_ptr<PairNode> PairPointer;
class PairNodes;  // makes them

// Q3 for sweeps, one by one, then Q4.
class SweepPairs {
 public:
  explicit SweepPairs(TileParts* parts);
  void check_tiles(const MicroSweep& sweep, uint64_t number);  // Q3
  void check_sweeps();                                         // Q4

 private:
  void descend(PairNodes* a, const PairPointer& first, PairNodes* b, const PairPointer& second,
               const char* id, uint64_t number);
  void add_pair(const char* id) {
    require(++pairs_ <= most_pairs_, id, "this checker has a limit of pairs of nodes");
  }

  TileParts& parts_;
  const MicroFile& file_;
  BlockTree blocks_;
  std::vector<DoubleBox> boxes_;  // contain the points of the sweeps
  const uint64_t most_pairs_;
  uint64_t pairs_ = 0;
};
