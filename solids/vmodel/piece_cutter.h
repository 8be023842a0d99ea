// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/piece_cutter.h: the Bernstein coefficients of the pieces of a cell, in integers and in rounded numbers.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "robust/integer.h"
#include "solids/vmodel/v_model.h"
#include "splines/bezier.h"

namespace veritope {

/// Homogeneous coefficients in binary64 up to one positive factor: component c of the exact ones is within error[c].
struct RoundedPiece {
  BezierVolume<double> map;
  std::array<double, 4> error{};
};

/// Cuts a cell at breaks that contain its knots.
class PieceCutter {
 public:
  /// REQUIRES a cell in space with clamped axes; breaks of the cell, along each axis, ascending. The cell stays alive.
  PieceCutter(const VVolume& cell, const std::array<std::vector<Rational>, 3>& breaks);

  Grid<3> grid() const;
  /// The piece's coefficients up to one positive factor. A polynomial cell has three components, without their common
  /// denominator. @cost products of integers: control points of a piece times degrees
  BezierVolume<Integer> exact(const std::array<std::size_t, 3>& piece) const;
  /// Close to coefficients that are those of exact() up to another positive factor.
  /// @cost if the piece is a whole Bezier cell: a conversion for each number
  RoundedPiece rounded(const std::array<std::size_t, 3>& piece) const;

 private:
  // From control points first, ..., first + degree to coefficients: a matrix, row by row, over a common denominator.
  struct Cut {
    std::size_t first;
    bool is_identity;
    std::vector<Integer> matrix;
  };
  bool is_whole(const std::array<std::size_t, 3>& piece) const;
  std::vector<const Rational*> box(const std::array<std::size_t, 3>& piece) const;

  const VVolume* cell_;
  std::array<std::vector<Cut>, 3> cuts_;
};

}  // namespace veritope
