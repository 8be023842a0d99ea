// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_off.cc: I1 of docs/certificates/micro-inside.md for the patches of tiles.
#include "micro_off.h"

namespace {

const int kMostLevelOff = 60;
const size_t kMostBlocksKept = 1 << 22;  // for I2

}  // namespace

OffSurface::OffSurface(TileParts* parts, Obstacle* surface)
    : file_(parts->file()),
      parts_(*parts),
      surface_(*surface),
      most_nodes_((uint64_t(1) << 22) + 64 * parts->count()) {}

void OffSurface::check_block(const MicroGrid& g, const size_t* box, const CellBlock& block) {
  if (!holds_tile(g, block)) return;
  const CellNet cell = parts_.net_in(g, box, block);
  PointHull hull;
  set_hull(cell.net, &hull);
  const bool is_off = surface_.misses_block(hull, &pairs_);
  add_nodes(0);
  if (is_off) {
    if (surface_.has_patches() && passed_.size() < kMostBlocksKept)
      passed_.insert(key_of(g, block));
    return;
  }
  if (block.is_cell()) return check_cell(g, block.lo, cell);
  const std::pair<CellBlock, CellBlock> halves = block.halves();
  check_block(g, box, halves.first);
  check_block(g, box, halves.second);
}
void OffSurface::check_cell(const MicroGrid& g, const size_t* i, const CellNet& cell) {
  const size_t tile = g.tile[g.cell(i)] - size_t(1);
  PointHull hull;
  std::vector<std::pair<DoubleNet, int>> nodes;  // with their levels
  for (size_t s = 0; s < file_.tiles[tile].patches.size(); ++s) {
    nodes.push_back(std::make_pair(parts_.patch_in(g, i, tile, s), 0));
    while (!nodes.empty()) {
      add_nodes(1);
      const std::pair<DoubleNet, int> node = std::move(nodes.back());
      nodes.pop_back();
      parts_.set_points(node.first, cell, &hull);
      if (surface_.misses(hull, &pairs_)) continue;
      require(node.second < kMostLevelOff, "I1", "a tile may meet the model, in cell",
              g.first_cell + g.cell(i));
      nodes.resize(nodes.size() + 2);
      std::pair<DoubleNet, int>* const halves = &nodes[nodes.size() - 2];
      halve_net(node.first, size_t(node.second % 2), &halves[0].first, &halves[1].first);
      halves[0].second = halves[1].second = node.second + 1;
    }
  }
}
void OffSurface::check_cells() {
  for (const MicroGrid& g : file_.grids)
    parts_.each_box(g,
                    [&](const size_t* box, const CellBlock& block) { check_block(g, box, block); });
}

void OffSurface::check_sweeps() {
  struct Node {
    DoubleNet cap;
    double lo, hi;
    int level;
  };
  for (const MicroSweep& b : file_.sweeps) {
    const uint64_t number = uint64_t(&b - file_.sweeps.data());
    const SweepPart part(&parts_, b, number, "I1");
    PointHull hull;
    std::vector<Node> nodes(1, Node{part.cap(), 0, 1, 0});
    while (!nodes.empty()) {
      add_nodes(1);
      const Node node = std::move(nodes.back());
      nodes.pop_back();
      part.set_points(node.cap, node.lo, node.hi, &hull);
      if (surface_.misses(hull, &pairs_)) continue;
      require(node.level < kMostLevelOff, "I1", "this sweep may meet the model:", number);
      Node lower = node, upper = node;
      lower.level = upper.level = node.level + 1;
      if (node.level % 3 == 2)
        lower.hi = upper.lo = (node.lo + node.hi) / 2;
      else
        halve_net(node.cap, size_t(node.level % 3), &lower.cap, &upper.cap);
      nodes.push_back(std::move(lower));
      nodes.push_back(std::move(upper));
    }
  }
}

OffSurface::BlockKey OffSurface::key_of(const MicroGrid& g, const CellBlock& b) const {
  return BlockKey{{uint32_t(&g - file_.grids.data()), uint32_t(b.lo[0]), uint32_t(b.lo[1]),
                   uint32_t(b.lo[2]), uint32_t(b.hi[0]), uint32_t(b.hi[1]), uint32_t(b.hi[2])}};
}
bool OffSurface::point_of_block(const PatchOfCell& patch, BlockKey* key, PointHull* hull) const {
  const MicroGrid& g = file_.grids[patch.grid];
  size_t i[3], box[3];
  g.place_of(patch.cell, i);
  parts_.box_of_cell(g, i, box);
  CellBlock block = parts_.block_of_box(g, box);
  while (passed_.count(key_of(g, block)) == 0) {
    if (block.is_cell()) return false;
    const std::pair<CellBlock, CellBlock> halves = block.halves();
    bool is_first = true;
    for (size_t a = 0; a < 3; ++a) is_first = is_first && i[a] < halves.first.hi[a];
    block = is_first ? halves.first : halves.second;
  }
  *key = key_of(g, block);
  set_hull(parts_.net_in(g, box, block).net, hull);
  return true;
}
void OffSurface::point_near(const PatchOfCell& patch, PointHull* hull) {
  const MicroGrid& g = file_.grids[patch.grid];
  size_t i[3];
  g.place_of(patch.cell, i);
  const CellNet cell = parts_.net_of_cell(g, i);
  DoubleNet node = parts_.patch_in(g, i, g.tile[patch.cell] - size_t(1), patch.patch);
  uint64_t pairs = 0;
  for (int level = 0;; ++level) {  // the half that begins at (0, 0)
    parts_.set_points(node, cell, hull);
    if (surface_.misses(*hull, &pairs)) break;
    require(level < kMostLevelOff, "I1", "a shell's first patch may meet the model, in cell",
            g.first_cell + patch.cell);
    restrict_net(&node, size_t(level % 2), 0, 0.5);
  }
}
