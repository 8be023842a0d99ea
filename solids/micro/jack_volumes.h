// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/jack_volumes.h: a jack as volumes, as figure 2 of [HPE22] has it.
#pragma once
#include <vector>

#include "solids/micro/jack.h"
#include "splines/bezier.h"

namespace veritope {

/// The cube in the middle, and then an arm to each wall of shape.arms, in the order of the walls. u, v and w run along
/// the axes of the unit cube, and each volume is right-handed; those of an arm have the degree of the shape along the
/// arm, and 1 otherwise. The cube and each arm have one face in common, as equal maps. Together they fill the surface
/// jack_tile(shape) at these numbers of the walls.
/// REQUIRES that jack_tile accepts the shape and, if it has a range, that the numbers of walls with arms are in it.
std::vector<BezierVolume<Rational>> jack_volumes(const JackShape& shape,
                                                 const WallNumbers& numbers);

}  // namespace veritope
