// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/compose/composed_cage.h: the tiles of a microstructure as a cage: volumes in the unit cube after the
// maps of their cells. Source: [HPE22], section 3.1, figure 5. Design: docs/design/0082-nested-microstructures.md.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/microstructure.h"
#include "splines/bezier.h"

namespace veritope {

/// The volumes of a kind of tile in the unit cube, at these numbers of a cell's walls.
using VolumesOfTile = std::function<std::vector<BezierVolume<Rational>>(
    std::size_t tile, const WallNumbers& numbers)>;

/// The volumes of all tiles in the order of grids, cells and volumes of the tile, each after the map of its cell, over
/// [0, 1]^3, with the least degrees that hold it. Nothing is rounded: volumes of one tile with equal faces have equal
/// faces, and so have neighbours whose volumes have equal faces in a common wall. Whether all that is a V-model, and
/// VALID, is not said. A volume has the hand of the cage's volume if it is right-handed in the cube.
/// @error kEmpty: no cell holds a tile; kOverLimit: more than max_volumes volumes, or one of a degree over kMaxVDegree
/// @cost  rational arithmetic: 0.2 ms for a volume of degree 1 in a trilinear one, much more for high degrees
/// REQUIRES validate(micro).
Result<std::vector<VVolume>> composed_cage(const Microstructure& micro,
                                           const VolumesOfTile& volumes,
                                           std::size_t max_volumes = kMaxMicroGrids);

}  // namespace veritope
