// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/collar/piece_octree.h: octree cells that pieces of patches meet, split one by one.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "solids/collar/octree_root.h"
#include "solids/pieces/piece_forest.h"
#include "topology/octree_key_set.h"

namespace veritope {

/// Cells that cover the surface: the hull of every piece that is small enough lies in their union, and its interior. At
/// first the root is the only cell. A cell is dropped when all pieces that meet it are so small that their hulls miss
/// it; it stays for good once a hull lies in it, or a piece that meets it is at most kPiece times as long as it. So the
/// union keeps close to the surface, and pieces are split near the walls of cells only.
class PieceOctree {
 public:
  static constexpr double kPiece = 0.25;

  /// The forest's budget, if it has one, is charged for the cells.
  /// @param memory  bytes that the nets of the forest may take
  PieceOctree(PieceForest& forest, const OctreeRoot& root, std::size_t memory);

  const OctreeRoot& root() const { return root_; }
  std::size_t num_cells() const { return cells_.size(); }
  /// Cells ascend.
  OctreeKey key(std::size_t cell) const { return cells_[cell].key; }
  std::vector<OctreeKey> keys() const;
  /// Calls visit(PieceForest::Id): all pieces that meet the closed cell are parts of these, whose hulls meet it.
  template <typename Visit>
  void for_each_piece(std::size_t cell, Visit visit) const {
    const Cell& c = cells_[cell];
    for (std::uint32_t k = 0; k < c.num_pieces; ++k) visit(pieces_[c.first_piece + k]);
  }
  /// Replaces the cells where `which` is true by those of their children that meet pieces. Returns false where the
  /// budget, or max_cells, would be exceeded; then the cells are no cover any more.
  /// REQUIRES which.size() == num_cells(), and a level below OctreeKey::kMaxLevel where it is true.
  [[nodiscard]] bool split(const std::vector<bool>& which,
                           std::size_t max_cells = OctreeKeySet::kMaxCells);

 private:
  struct Cell {
    OctreeKey key;
    std::uint32_t first_piece, num_pieces;
  };
  static_assert(sizeof(Cell) <= 16, "there are millions of cells");
  // Deques give back what was taken from their front, so that old and new cells are not there together.
  using Cells = std::deque<Cell>;
  using Pieces = std::deque<PieceForest::Id>;

  bool is_met(PieceForest::Id id, const Box3d& box);
  void gather(PieceForest::Id id, const Box3d& box, std::vector<PieceForest::Id>* out);
  bool split(OctreeKey key, const std::vector<PieceForest::Id>& pieces);
  bool add(OctreeKey key, const std::vector<PieceForest::Id>& pieces);

  PieceForest& forest_;
  OctreeRoot root_;
  std::size_t memory_;
  Cells cells_, next_cells_;
  Pieces pieces_, next_pieces_;
  MemoryShare share_;
};

}  // namespace veritope
