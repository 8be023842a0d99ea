// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/synthesis/tile_places.h: which of several tiles each cell holds, by a formula.
#pragma once
#include <cstddef>
#include <cstdint>

#include "interval/formula/formula_evaluator.h"
#include "robust/base/result.h"
#include "solids/micro/microstructure.h"

namespace veritope {

/// The number of the tile is the value of a formula of kWallVariables at the middle of the cell, rounded to a multiple
/// of 2^-20, then down to an integer. rand depends on the cell.
class TilePlaces {
 public:
  /// REQUIRES that the formula outlives it.
  TilePlaces(const RealFormula& formula, std::size_t num_tiles)
      : formula_(formula), evaluator_(formula), num_tiles_(num_tiles) {}

  /// @error kBadArgument: no value, a value that is not decided, or a number that is not one of a tile; the cell and
  /// the value are named
  Result<std::size_t> operator()(const VVolume& volume, const MicroGrid& grid, std::uint64_t cell);

 private:
  const RealFormula& formula_;
  FormulaEvaluator evaluator_;
  std::size_t num_tiles_;
};

}  // namespace veritope
