// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/half_spaces.h: condition S1 of a piece as half-spaces for a centre. Approximate: nothing here decides.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "solids/pieces/piece_forest.h"
#include "verify/certify/centre_search.h"

namespace veritope {

/// Coordinates (c - middle) / scale for a centre c.
struct CentreCoordinates {
  const Point3d& middle;
  const Point3d& scale;
};

/// Adds g_c > 0 for coefficients of the piece: all coefficients, or approximately `most`, evenly spread. A coefficient
/// that does not depend on c adds a half-space with a = 0 and b = -1, which is never satisfied. Returns whether all
/// were added.
bool append_half_spaces(PieceForest& forest, PieceForest::Id id, const CentreCoordinates& in,
                        std::size_t most, std::vector<HalfSpace>* out);

/// Coordinates z for a centre c = middle + z[0] steps[0] + z[1] steps[1] + z[2] steps[2].
struct CentreSteps {
  Point3d middle;
  std::array<Point3d, 3> steps;
};

/// Adds g_c > 0 for coefficients of the piece, chosen in the same way, but for those whose normals are zero, or shorter
/// than their errors: they say nothing.
void append_half_spaces_in_steps(PieceForest& forest, PieceForest::Id id, const CentreSteps& in,
                                 std::size_t most, std::vector<HalfSpace>* out);

}  // namespace veritope
