// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/scale_floor_internal.h: whether the determinant of a map stays above a number, as doubles have
// it. It proves nothing; searches keep their nets away from folds with it.
#pragma once
#include "splines/bezier.h"

namespace veritope::internal {

/// False where a coefficient of det J stays below `least` after so many halvings in a row, or a corner has less.
/// REQUIRES a polynomial map.
bool has_scale(const BezierVolume<double>& map, double least, int halvings);

}  // namespace veritope::internal
