// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/collar/piece_octree.h: octree cells that pieces of patches meet, split one by one.
#pragma once
#include <cstdint>
#include <vector>

#include "solids/collar/octree_root.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// Cells that cover the surface: the hull of every piece that is small enough lies in their union, and its interior. At
/// first the root is the only cell. A cell is dropped when all pieces that meet it are so small that their hulls miss
/// it; it stays for good once a hull lies in it, or a piece that meets it is at most kPiece times as long as it. So the
/// union keeps close to the surface, and pieces are split near the walls of cells only.
class PieceOctree {
 public:
  static constexpr double kPiece = 0.25;

  struct Cell {
    OctreeKey key;
    /// All pieces that meet the closed cell are parts of these, whose hulls meet it.
    std::vector<PieceForest::Id> pieces;
  };

  /// `memory`: bytes that the nets of the forest may take.
  PieceOctree(PieceForest& forest, const OctreeRoot& root, std::size_t memory);

  const OctreeRoot& root() const { return root_; }
  /// The cells, ascending.
  const std::vector<Cell>& cells() const { return cells_; }
  std::vector<OctreeKey> keys() const;
  /// Replaces the cells where `which` is true by those of their children that meet pieces.
  /// REQUIRES which.size() == cells().size(), and a level below OctreeKey::kMaxLevel where it is true.
  void split(const std::vector<bool>& which);

 private:
  bool is_met(PieceForest::Id id, const Box3d& box);
  void gather(PieceForest::Id id, const Box3d& box, std::vector<PieceForest::Id>* out);

  PieceForest& forest_;
  OctreeRoot root_;
  std::size_t memory_;
  std::vector<Cell> cells_;
};

}  // namespace veritope
