// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/crossing_number.h: how often the line through two points passes through a union of pieces, counted with
// orientation. Theory: docs/THEORY.md §4.
#pragma once
#include <optional>
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope {

/// The line through two different points, in the coordinates of a forest; directed from `inside` to `outside`.
struct CentreLine {
  Point3d inside, outside;
};

/// The crossing number of the line with the union of the pieces, from the winding of its boundary; nothing if the
/// bounds of doubles do not decide, or the budget of halvings is spent.
/// REQUIRES that the signs of both points (PieceForest::side_of) are known on all pieces, and `tested` from find_pieces
/// or find_star_pieces.
std::optional<int> crossing_number(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                                   const CentreLine& line);

}  // namespace veritope
