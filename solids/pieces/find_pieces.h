// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/find_pieces.h: the pieces of a forest that a box meets.
#pragma once
#include <cstddef>
#include <vector>

#include "solids/pieces/piece_descent.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// A box that contains the surface.
Box3d hull_of_roots(const PieceForest& forest);

/// Appends to `tested` the pieces that `box` meets, none of them longer than `longest`; drops the others because their
/// hulls miss the box. Every visited piece whose hull lies in the box, tested or split, is appended to `held`, parents
/// before their children. Returns false if a piece of the greatest level is still longer, if more than `most` pieces
/// meet the box, or if the descent visits 16 times as many.
bool find_pieces(PieceForest& forest, const Box3d& box, double longest, std::size_t most,
                 std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held);

namespace internal {

/// The pieces that find_pieces describes, with `is_small(id)` in place of the length: it says whether a piece is taken
/// without a split.
template <typename IsSmall>
bool find_small_pieces(PieceForest& forest, const Box3d& box, IsSmall is_small, std::size_t most,
                       std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  return descend_to(forest, box, 16 * most, [&](PieceForest::Id id) {
    if (is_inside(forest.node(id).hull, box)) held->push_back(id);
    if (!is_small(id)) return PieceStep::kSplit;
    tested->push_back(id);
    return tested->size() <= most ? PieceStep::kTaken : PieceStep::kStop;
  });
}

}  // namespace internal

}  // namespace veritope
