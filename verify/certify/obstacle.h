// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/obstacle.h: what stands in the way of a star box: how near sheets pass that face each other, how far
// normals spread. Approximate: for the order of a search and for messages; nothing here decides.
#pragma once
#include <limits>
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope {

struct Obstacle {
  /// Between pieces whose normals are over 105 degrees apart, along their normals: infinity without such pieces. 0 in a
  /// contact.
  double gap = std::numeric_limits<double>::infinity();
  /// The gap minus what the piece bends by, at least 0: between the points that are examined, sheets may come so near.
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

}  // namespace veritope
