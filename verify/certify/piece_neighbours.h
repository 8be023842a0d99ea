// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/piece_neighbours.h: whether two pieces have a point of the abstract surface in common: decided in
// integers only.
#pragma once
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// Whether the closed pieces have a common point in the surface to which the complex's patches are glued: within one
/// patch, on a common edge, or in a common vertex (a collapsed side counts as its vertex). Also true for some pairs of
/// pieces of one triangle that are near each other and have no common point.
bool are_neighbours(const PieceForest& forest, PieceForest::Id a, PieceForest::Id b);

}  // namespace veritope
