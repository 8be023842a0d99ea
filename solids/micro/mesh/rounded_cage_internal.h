// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/rounded_cage_internal.h: a polynomial volume on the cells of a grid in binary64, with one bound of
// all errors: values at many points at a low cost. Bound: docs/bounds/micro_mesh.md. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "solids/micro/mesh/cage_cells_internal.h"

namespace veritope::internal {

/// Approximate Bernstein coefficients of the map of a cell, which takes the unit cube to space.
struct RoundedCell {
  std::array<std::size_t, 3> size{};          ///< degrees + 1
  std::array<std::vector<double>, 3> values;  ///< by coordinates; the third parameter fastest
};

/// All functions REQUIRE a live ScopedDefaultFp, and compute the same bits on every processor.
class RoundedCage {
 public:
  /// REQUIRES a grid of this volume, and a polynomial map to space.
  RoundedCage(const VVolume& volume, const MicroGrid& grid);

  /// No coefficient of a cell is farther from the exact one, coordinate by coordinate.
  double coefficient_error() const { return coefficient_error_; }
  /// No value that map_points (mesh_lanes_internal.h) computes from the coefficients, at points of the unit cube, is
  /// farther from the exact one.
  double value_error() const { return value_error_; }

  /// The coefficients of a row of cells (i, j, .), not yet cut along the third axis.
  void enter_row(std::size_t i, std::size_t j, std::vector<double>& row) const;
  void cell(const std::vector<double>& row, std::size_t k, RoundedCell& out) const;

  /// Bounds as those of CellMap::bounds(0). `is_loose`: halving the cell may give better ones.
  CellMapBounds bounds(const RoundedCell& cell, bool& is_loose) const;

 private:
  // Takes control points first, ..., first + degree to the coefficients on an interval: row by row.
  struct Cut {
    std::size_t first = 0;
    std::vector<double> matrix;
  };
  std::array<std::size_t, 3> size_{};  // degrees + 1
  std::array<std::size_t, 3> net_size_{};
  std::vector<double> net_;  // point after point
  std::array<std::vector<Cut>, 3> cuts_;
  double coefficient_error_ = 0, value_error_ = 0;
};

}  // namespace veritope::internal
