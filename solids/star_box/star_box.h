// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/star_box.h: tests conditions S1 and S2 for one box with two centres. Theory: docs/THEORY.md §4.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/pieces/crossing_number.h"
#include "solids/pieces/find_pieces.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// In the coordinates of a forest. REQUIRES both centres in the interior.
struct StarBox {
  Box3d box;
  Point3d inside, outside;  ///< c-, c+
};

/// Finds pieces as find_pieces does, but takes a piece as soon as S1 holds on it. The pieces suit has_star_signs and
/// crossing_number.
bool find_star_pieces(PieceForest& forest, const StarBox& star, std::size_t most,
                      std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held);

/// Whether S1 holds on the piece for these centres.
bool has_star_signs(PieceForest& forest, PieceForest::Id id, const CentreLine& centres);

/// Whether S1 holds on all of the pieces.
bool has_star_signs(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                    const StarBox& star);

/// S2: the crossing number of the line through the centres. REQUIRES has_star_signs(forest, tested, star), and `tested`
/// from find_pieces or find_star_pieces.
inline std::optional<int> crossing_number(PieceForest& forest,
                                          const std::vector<PieceForest::Id>& tested,
                                          const StarBox& star) {
  return crossing_number(forest, tested, CentreLine{star.inside, star.outside});
}

}  // namespace veritope
