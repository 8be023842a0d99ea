// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/piece_octree.h"

#include <utility>

#include "robust/base/check.h"

namespace veritope {

using Id = PieceForest::Id;

PieceOctree::PieceOctree(PieceForest& forest, const OctreeRoot& root, std::size_t memory)
    : forest_(forest), root_(root), memory_(memory) {
  Cell all;
  for (std::uint32_t r = 0; r < forest.num_roots(); ++r)
    gather(forest.root(r), root.box(), kPiece * root.edge(), &all.pieces);
  cells_.push_back(std::move(all));
}

std::vector<OctreeKey> PieceOctree::keys() const {
  std::vector<OctreeKey> out;
  out.reserve(cells_.size());
  for (const Cell& c : cells_) out.push_back(c.key);
  return out;
}

void PieceOctree::gather(Id id, const Box3d& box, double longest, std::vector<Id>* out) {
  const Box3d hull = forest_.node(id).hull;
  if (!meets(hull, box)) return;
  if (extent(hull) <= longest || is_inside(hull, box) ||
      forest_.node(id).level >= PieceForest::kMaxLevel) {
    out->push_back(id);
    return;
  }
  const Id first = forest_.children(id);
  for (Id k = 0; k < 4; ++k) gather(first + k, box, longest, out);
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
      for (const Id id : cells_[i].pieces) gather(id, box, kPiece * extent(box), &child.pieces);
      if (!child.pieces.empty()) out.push_back(std::move(child));
    }
    cells_[i].pieces = {};
  }
  cells_ = std::move(out);
}

}  // namespace veritope
