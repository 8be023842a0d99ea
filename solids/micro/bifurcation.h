// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bifurcation.h: a tile between jacks and jacks of half the width along u and v: at its wall w1 it has the
// caps of 2 x 2 of them. Source: [HPE22], section 4, which has such tiles from its reference 16.
#pragma once
#include "robust/base/result.h"
#include "solids/micro/jack.h"

namespace veritope {

/// A jack without its arm to w1: four arms lead to squares with the edge `cap` in the middles of the quarters of that
/// wall. They all depend on its number, as the jack's arm does. `arms` has no bit for w1. If the degree is 3 and the
/// range is null, the arms meet those of the jacks with a common tangent plane, and the tile is not a star; else it
/// is one, for usual numbers, and there are kinks at that wall.
/// @error as jack_tile; kBadArgument for a bit for w1
Result<MicroTile> bifurcation_tile(const JackShape& shape);

}  // namespace veritope
