// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/piece_octree.h"

#include <utility>

#include "robust/base/check.h"

namespace veritope {

using Id = PieceForest::Id;

PieceOctree::PieceOctree(PieceForest& forest, const OctreeRoot& root, std::size_t memory)
    : forest_(forest), root_(root), memory_(memory) {
  Cell all;
  for (std::uint32_t r = 0; r < forest.num_roots(); ++r) all.pieces.push_back(forest.root(r));
  cells_.push_back(std::move(all));
}

std::vector<OctreeKey> PieceOctree::keys() const {
  std::vector<OctreeKey> out;
  out.reserve(cells_.size());
  for (const Cell& c : cells_) out.push_back(c.key);
  return out;
}

// Whether the surface comes as near as kPiece says.
bool PieceOctree::is_met(Id id, const Box3d& box) {
  const Box3d hull = forest_.node(id).hull;
  if (!meets(hull, box)) return false;
  if (extent(hull) <= kPiece * extent(box) || is_inside(hull, box) ||
      forest_.node(id).level >= PieceForest::kMaxLevel)
    return true;
  const Id first = forest_.children(id);
  for (Id k = 0; k < 4; ++k)
    if (is_met(first + k, box)) return true;
  return false;
}

// The parts of a piece that meet the box: as far as they are known, and not much longer than it.
void PieceOctree::gather(Id id, const Box3d& box, std::vector<Id>* out) {
  const PieceForest::Node& node = forest_.node(id);
  if (!meets(node.hull, box)) return;
  if (node.first_child == PieceForest::kNone || extent(node.hull) <= extent(box)) {
    out->push_back(id);
    return;
  }
  for (Id k = 0; k < 4; ++k) gather(forest_.node(id).first_child + k, box, out);
}

void PieceOctree::split(const std::vector<bool>& which) {
  VT_CHECK(which.size() == cells_.size(), "one flag for each cell");
  std::vector<Cell> out;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!which[i]) {
      out.push_back(std::move(cells_[i]));
      continue;
    }
    forest_.limit_memory(memory_);
    for (unsigned octant = 0; octant < 8; ++octant) {
      Cell child{cells_[i].key.child(octant), {}};
      const Box3d box = root_.box(child.key);
      for (const Id id : cells_[i].pieces) gather(id, box, &child.pieces);
      std::erase_if(child.pieces, [&](Id id) { return !is_met(id, box); });
      if (!child.pieces.empty()) out.push_back(std::move(child));
    }
    cells_[i].pieces = {};
  }
  cells_ = std::move(out);
}

}  // namespace veritope
