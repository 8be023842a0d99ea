// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/open_tile.h: tiles of curves and sheets. They are filtered, composed and written; no claim is made of
// them: nobody certifies that their parts are apart from each other, or hang together. Source: [HPE22], section 3.5.
// Design: docs/design/0083-curves-and-sheets.md.
#pragma once
#include <optional>

#include "robust/base/result.h"
#include "solids/micro/tile_analysis.h"

namespace veritope {

/// Three coils, one along each axis a, around the line on which the next coordinate is 1/4 and the one after it 3/4.
/// Each is a periodic cubic spline of four spans: those of neighbouring cells are one curve with two derivatives.
struct Curves3Shape {
  /// How far the control points are from the line, in (0, 1/4). The curve is 2/3 as far at its knots.
  Rational radius = Rational(1) / Rational(6);
  /// If set, each curve is replaced by so many straight segments, 1 to 256, between its points at equal parameters.
  std::optional<int> parts;
};

/// The curves' polynomial pieces, in order along the axes 0, 1, 2.
/// @error kBadArgument: a number outside of its range, with its value
Result<MicroTile> curves3_tile(const Curves3Shape& shape);

/// The patches of a tile but for those that lie in a wall of the cube for every number of their wall: its surface
/// without caps, as sheets.
MicroTile sheets_of(MicroTile tile);

/// @error as check_tile, but that curves are admitted; kBadArgument: a control point out of the unit cube (those of
///        patches that depend on no number are looked at)
Status check_open_tile(const MicroTile& tile);

/// The tile without caps, for ComposedSurface. REQUIRES an open tile.
AnalysedTile analysis_of_open(MicroTile tile);

}  // namespace veritope
