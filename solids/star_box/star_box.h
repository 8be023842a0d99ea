// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/star_box.h: conditions S1 and S2 of one box with two centres. Theory: docs/THEORY.md §4.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/star_box/piece_forest.h"

namespace veritope {

/// In the coordinates of a forest. REQUIRES both centres in the interior.
struct StarBox {
  Box3d box;
  Point3d inside, outside;  ///< c-, c+
};

/// Contains the surface.
Box3d hull_of_roots(const PieceForest& forest);

/// Pieces that are met by `box`, none longer than `longest`, appended to `tested`; others dropped because their hulls miss the box.
/// Pieces on the way whose hulls lie in the box, and tested ones, go to `held`, a parent before its children.
/// False if a piece of the greatest level is still longer, over `most` pieces are met, or 16 times as many on the way.
bool find_pieces(PieceForest& forest, const Box3d& box, double longest, std::size_t most,
                 std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held);

/// The same with S1 instead of a length: pieces that are met by the box, and on which S1 holds. They fit has_star_signs and crossing_number.
bool find_star_pieces(PieceForest& forest, const StarBox& star, std::size_t most,
                      std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held);

/// S1 on all of the pieces.
bool has_star_signs(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                    const StarBox& star);

/// The crossing number of the line through c- and c+ with the union of the pieces, from the winding of its boundary; nothing if the bounds of doubles
/// do not decide, or the budget of halvings is spent.
/// REQUIRES has_star_signs(forest, tested, star), and `tested` from find_pieces or find_star_pieces.
std::optional<int> crossing_number(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                                   const StarBox& star);

}  // namespace veritope
