// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/frame.h: a tile with a hollow: three square rings around the middle of the cube, each across two others,
// and stubs from their crossings to the walls.
#pragma once
#include "robust/base/result.h"
#include "solids/micro/micro_tile.h"

namespace veritope {

/// Along each axis the rings reach from `margin` to 1 - margin, and all bars are squares with the edge `bar`. The six
/// crossings lie before the middles of the walls, and 12 bars join them: the solid has the genus 7.
struct FrameShape {
  Rational bar = Rational(1) / Rational(6);
  Rational margin = Rational(1) / Rational(6);  ///< how long the stubs are
  /// A bit for each wall 2 axis + end to which a stub reaches.
  unsigned arms = 63;
};

/// Flat squares and rectangles; each cap is one square with the edge `bar` in the middle of its wall.
/// @error kBadArgument unless bar > 0, margin > 0 and margin + 3/2 bar < 1/2
Result<MicroTile> frame_tile(const FrameShape& shape);

}  // namespace veritope
