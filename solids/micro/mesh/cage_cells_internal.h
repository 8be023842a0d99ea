// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/cage_cells_internal.h: the map of a volume on the cells of a grid, each as a map of the unit cube
// in Bernstein form over intervals: values, and bounds of its derivatives. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "interval/box.h"
#include "solids/micro/microstructure.h"

namespace veritope::internal {

/// Upper bounds over the unit cube: lengths of the first and second partial derivatives of a map.
struct CellMapBounds {
  std::array<double, 3> first{};
  std::array<double, 6> second{};  ///< 00, 11, 22, 01, 02, 12
};

/// The map of a cell, which takes the unit cube to space. All functions REQUIRE a live ScopedUpward.
class CellMap {
 public:
  CellMap(const std::array<int, 3>& degrees, bool is_rational);

  /// Contains the image of every point of the box. REQUIRES a box in the unit cube.
  /// @cost products: the coefficients of all components, and a bit more
  Box3 value(const Box3& at) const;
  /// Polynomial maps: from differences of coefficients. Rational maps: by the quotient rule, with the middle of the
  /// cell as the origin. Where the bounds are loose, the cell is halved along all axes, at most `depth` times.
  /// Infinite if the coefficients are not finite, or the weights not proved positive.
  CellMapBounds bounds(int depth) const;
  /// bounds(0). `is_loose`: a depth of 1 may give better ones.
  CellMapBounds whole_bounds(bool& is_loose) const;

 private:
  friend class CageCells;
  std::size_t num_points() const { return size_[0] * size_[1] * size_[2]; }
  // Keeps the lower or upper half along an axis.
  void halve(std::size_t axis, bool keeps_upper);

  std::array<std::size_t, 3> size_;  // degrees + 1
  std::size_t num_components_;
  std::vector<Interval> coefficients_;  // point after point, the third parameter fastest
  std::array<std::vector<Interval>, 3> binomials_;
};

/// A row of cells (i, j, .) of a grid, as far as they share work.
class CageRow {
 private:
  friend class CageCells;
  std::vector<Interval> net_;  // Bernstein along two axes, control points along the third
};

class CageCells {
 public:
  /// REQUIRES a grid of this volume, a map to space, and a live ScopedUpward.
  CageCells(const VVolume& volume, const MicroGrid& grid);

  CellMap new_map() const { return {degrees_, num_components_ == 4}; }
  /// @cost (degree + 1)^3 times the control points that the row uses along the third axis
  void enter_row(std::size_t i, std::size_t j, CageRow& row) const;
  /// The map of cell (i, j, k) of the row.
  void cell(const CageRow& row, std::size_t k, CellMap& map) const;

 private:
  // Takes control points first, ..., first + degree to the Bernstein coefficients on an interval: row by row.
  struct Cut {
    std::size_t first;
    std::vector<Interval> matrix;
  };
  std::array<int, 3> degrees_;
  std::size_t num_components_;
  std::array<std::size_t, 3> net_size_;
  std::vector<Interval> net_;  // point after point
  std::array<std::vector<Cut>, 3> cuts_;
};

}  // namespace veritope::internal
