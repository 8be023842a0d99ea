// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/curve_ends.h: the ends of the curves of tiles that no other curve continues, and the images of ends with
// their tangents. Nothing is rounded. Source: [HPE22], algorithm 3, for the curves of figure 9. Design:
// docs/design/0086-bridges-of-curves.md.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "solids/micro/cell_piece.h"
#include "solids/micro/microstructure.h"

namespace veritope {

/// An end of a curve of a cell's tile.
struct CurveEnd {
  std::uint32_t grid = 0;
  std::uint64_t cell = 0;
  std::uint32_t patch = 0;  ///< the number of the curve among the tile's patches
  bool is_last = false;     ///< the end at the parameter 1, else that at 0
  friend auto operator<=>(const CurveEnd&, const CurveEnd&) = default;
};

/// The free ends: those in a wall of their cell whose image is that of no other end of a curve of a cell that holds a
/// tile. Where curves of one tile meet in a wall, none of them has a free end. Ascending.
/// REQUIRES validate(micro) but for open tiles, whose curves depend on no number of a wall; a cage that is one to one
/// on each volume's open box.
/// @cost near-linear in the ends in walls; the map is evaluated at ends in the faces of grids only
std::vector<CurveEnd> free_curve_ends(const Microstructure& micro);

/// An end in space.
struct CurveEndPlace {
  std::array<Rational, 3> at, tangent;
};
/// The image of an end, and the derivative of the curve in space there by its parameter in [0, 1], in the direction
/// that leads out of the curve. It may be 0.
/// REQUIRES a curve of a cell that holds a tile, a weight that is not 0 at the end, and a piece of micro, which goes to
/// the cell.
CurveEndPlace place_of(const Microstructure& micro, const CurveEnd& end, CellPiece& piece);

}  // namespace veritope
