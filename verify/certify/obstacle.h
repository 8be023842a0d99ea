// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/obstacle.h: what prevents a star box: how near to each other sheets pass that face each other, and how
// far normals spread. Approximate: for the order of a search and for messages; nothing here decides.
#pragma once
#include <array>
#include <limits>
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope {

struct Obstacle {
  /// The least distance, along their normals, of pieces whose normals are over 105 degrees apart; infinity without such
  /// pieces, 0 at a contact.
  double gap = std::numeric_limits<double>::infinity();
  /// The pieces between which the gap is, the first one a part of the piece; kNone without a gap.
  std::array<PieceForest::Id, 2> facing{PieceForest::kNone, PieceForest::kNone};
  /// The gap minus the piece's bend, at least 0: sheets may come this near between the points that are examined.
  double least_gap = std::numeric_limits<double>::infinity();
  /// The least cosine of the angle between two normals.
  double least_cosine = 1;
};

/// The obstacle between the parts of `piece` among `near` and all of `near`. REQUIRES every piece of `near` is the
/// piece, a part of it, or apart from it.
/// @cost O(64 |near|)
Obstacle find_obstacle(PieceForest& forest, PieceForest::Id piece,
                       const std::vector<PieceForest::Id>& near);

/// The gap of two pieces; infinity unless they face each other.
double gap_between(PieceForest& forest, PieceForest::Id a, PieceForest::Id b);
/// That gap in the model's units: the frame may have other units along each axis.
double gap_in_model(PieceForest& forest, PieceForest::Id a, PieceForest::Id b);

}  // namespace veritope
