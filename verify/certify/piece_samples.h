// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/piece_samples.h: points and chords of a piece, approximately, for searches.
#pragma once
#include <vector>

#include "solids/pieces/piece_forest.h"
#include "verify/certify/shape_metric.h"

namespace veritope {

/// Appends nine points of a tensor piece (six of a triangle): corners, middles of sides, and the middle.
void append_samples(PieceForest& forest, PieceForest::Id id, std::vector<Point3d>* out);

/// The longest of the differences between corners that are neighbours.
Point3d longest_chord(PieceForest& forest, PieceForest::Id id, const ShapeMetric& metric);

/// How far, in lengths, the control points leave the plane through one of them across the mean normal; infinity without
/// a normal.
double approx_bend(PieceForest& forest, PieceForest::Id id, const ShapeMetric& metric);

}  // namespace veritope
