// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/split_cage.h: cells cut in two whose walls stay glued, or open in a crack.
// Source: seed paper 003, figures 6b and 6c: a knot of full multiplicity makes separate parameter boxes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/base/result.h"
#include "solids/volumes/cell_maps.h"

namespace veritope {

/// A wall that opens towards a face of the cell: from the line where the parameter of another axis is `from`, on. There
/// the cell is cut, too, so that its map is only C^0. Beyond, both copies of the wall move apart: by the vectors at the
/// face, and proportionally less before it, down to 0 at the line.
struct CageCrack {
  std::size_t axis = 2;     ///< the face is across this axis
  bool is_at_end = true;    ///< at its end, or at its begin
  Rational from;            ///< in the cell's parameters
  CellPoint low{}, high{};  ///< moves of the copies that belong to lower and to higher parameters
};

struct CageSplit {
  std::uint32_t cell = 0;
  std::size_t axis = 0;
  Rational at;
  std::optional<CageCrack> crack;
};

/// The most cells of the result.
inline constexpr std::size_t kMaxSplitCells = std::size_t{1} << 16;

/// Cuts the cell at a parameter, and in the same way all cells that are glued to it across walls that the cut crosses
/// (v_model.h), so that equal walls stay equal: the parts are glued where the cells were. Each cell is followed by its
/// parts, those of lower parameters first, w fastest. Control points of a part beside the crack move by the vector,
/// times the Greville abscissa from the opposite wall to the crack, times that from the line to the face; other cells
/// stay as they are.
/// A crack opens with an angle that is not 0 where `low` and `high` differ by more than a tangent vector of the wall.
/// That the parts still exclude one another is for a certifier to say.
/// @error kBadArgument for a cell that does not exist; a parameter that is not inside of the domain; a crack whose axis
///        is that of the cut, or whose vectors are equal. As make_v_model. kOverLimit for more than kMaxSplitCells
///        cells, also where a cell glued to itself would have to be cut without end.
Result<std::vector<CellVolume>> split_cage(std::vector<CellVolume> cells, const CageSplit& split);

}  // namespace veritope
