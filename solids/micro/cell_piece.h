// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cell_piece.h: a cell in the polynomial piece of its volume.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "solids/micro/microstructure.h"
#include "splines/bezier.h"

namespace veritope {

/// The polynomial piece of a volume to which a cell belongs, as a map of [0, 1]^3, and the box of the cell in it.
class CellPiece {
 public:
  /// REQUIRES that micro outlives it.
  explicit CellPiece(const Microstructure& micro) : micro_(&micro) {}

  /// Goes to a cell of the grid; the piece is kept if the cell before was in it.
  void enter(std::size_t grid, const std::array<std::size_t, 3>& cell);

  /// REQUIRES that a cell was entered, as brought and stretched do.
  const BezierVolume<Rational>& map() const { return *map_; }
  /// A coordinate of the unit cube as one of the piece's parameters.
  Rational brought(std::size_t axis, const Rational& x) const {
    return offset_[axis] + width_[axis] * x;
  }
  /// A difference of coordinates of the unit cube, likewise.
  Rational stretched(std::size_t axis, const Rational& x) const { return width_[axis] * x; }

 private:
  const Microstructure* micro_;
  std::size_t grid_ = 0;
  std::array<std::size_t, 3> spans_{};
  std::optional<BezierVolume<Rational>> map_;
  std::array<Rational, 3> offset_, width_;
};

}  // namespace veritope
