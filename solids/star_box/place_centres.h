// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/place_centres.h: where to look first for the centres of a star box. Approximate: S1 and S2 decide.
#pragma once
#include <vector>

#include "solids/star_box/star_box.h"

namespace veritope {

/// How much a piece counts in mean_normal.
enum class NormalWeight {
  kSize,   ///< large pieces count more: around one piece, its own parts and what lies near
  kEqual,  ///< all pieces count alike: in a box where V is unknown, so that one large piece does not hide the rest
};

/// The sum of the pieces' approximate normals, not of unit length.
Point3d mean_normal(PieceForest& forest, const std::vector<PieceForest::Id>& pieces,
                    NormalWeight weight);

/// Places both centres of `star` on a line through the middle of its box, at `part` of the way to the border of the
/// box. `direction` is that of the line in coordinates in which the box is a cube. Returns false, and places nothing,
/// if it has no direction in doubles.
bool place_centres(const Point3d& direction, double part, StarBox* star);

/// Whether both centres lie in the interior of the box and S1 holds on all of the pieces.
bool are_centres(PieceForest& forest, const std::vector<PieceForest::Id>& pieces,
                 const StarBox& star);

}  // namespace veritope
