// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/piece_octree.h"

#include <utility>

#include "robust/base/check.h"

namespace veritope {

using Id = PieceForest::Id;

namespace {
constexpr std::uint64_t kMostPieces = ~std::uint32_t{0};
}  // namespace

PieceOctree::PieceOctree(PieceForest& forest, const OctreeRoot& root, std::size_t memory)
    : forest_(forest), root_(root), memory_(memory), share_(forest.budget()) {
  for (std::uint32_t r = 0; r < forest.num_roots(); ++r) pieces_.push_back(forest.root(r));
  cells_.push_back({OctreeKey(), 0, static_cast<std::uint32_t>(forest.num_roots())});
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
  if (extent(hull) <= kPiece * extent(box) || is_inside(hull, box) || !forest_.may_split(id))
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

bool PieceOctree::split(const std::vector<bool>& which, std::size_t max_cells) {
  VT_CHECK(which.size() == cells_.size(), "one flag for each cell");
  std::vector<Id> pieces;
  for (const bool is_split : which) {
    const Cell cell = cells_.front();
    pieces.assign(pieces_.begin(), pieces_.begin() + cell.num_pieces);
    cells_.pop_front();
    pieces_.erase(pieces_.begin(), pieces_.begin() + cell.num_pieces);
    if (!(is_split ? split(cell.key, pieces) : add(cell.key, pieces)) ||
        next_cells_.size() > max_cells)
      return false;
  }
  cells_ = std::exchange(next_cells_, {});
  pieces_ = std::exchange(next_pieces_, {});
  return true;
}

bool PieceOctree::split(OctreeKey key, const std::vector<Id>& pieces) {
  std::vector<Id> met;
  forest_.limit_memory(memory_);
  for (unsigned octant = 0; octant < 8; ++octant) {
    const OctreeKey child = key.child(octant);
    const Box3d box = root_.box(child);
    met.clear();
    for (const Id id : pieces) gather(id, box, &met);
    std::erase_if(met, [&](Id id) { return !is_met(id, box); });
    if (forest_.is_out_of_memory() || (!met.empty() && !add(child, met))) return false;
  }
  return true;
}

bool PieceOctree::add(OctreeKey key, const std::vector<Id>& pieces) {
  const std::uint64_t num_cells = cells_.size() + next_cells_.size() + 1,
                      num_pieces = pieces_.size() + next_pieces_.size() + pieces.size();
  if (num_pieces > kMostPieces || !share_.resize(num_cells * sizeof(Cell) + num_pieces * sizeof(Id)))
    return false;
  next_cells_.push_back({key, static_cast<std::uint32_t>(next_pieces_.size()),
                         static_cast<std::uint32_t>(pieces.size())});
  next_pieces_.insert(next_pieces_.end(), pieces.begin(), pieces.end());
  return true;
}

}  // namespace veritope
