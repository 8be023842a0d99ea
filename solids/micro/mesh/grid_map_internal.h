// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/grid_map_internal.h: the map of a volume on the cells of a grid, for meshes: polynomial maps in
// binary64, rational ones in intervals. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "solids/micro/mesh/mesh_lanes_internal.h"
#include "solids/micro/mesh/rounded_cage_internal.h"
#include "solids/micro/mesh/tile_mesh_internal.h"
#include "solids/micro/mesh/vertex_rounding_internal.h"

namespace veritope::internal {

class GridMap {
 public:
  GridMap(const VVolume& volume, const MicroGrid& grid);

  /// How far the vertices of a polynomial map may be from their points; 0 for a rational map, whose vertices have
  /// their own bounds. `first`: bounds of the first derivatives of all its cells.
  double rounding_of(const TileMesh& mesh, const std::array<double, 3>& first) const;
  /// A part of it that no mesh can do without.
  double least_rounding() const;

 private:
  friend class CellOnCage;
  CageCells cells_;
  std::optional<RoundedCage> rounded_;
};

/// A cell that goes through the rows of a grid. All functions REQUIRE a live ScopedDefaultFp.
class CellOnCage {
 public:
  explicit CellOnCage(const GridMap& map);

  void enter_row(std::size_t i, std::size_t j);
  /// REQUIRES a row.
  void enter_cell(std::size_t k);

  /// `is_loose`: refined_bounds may be better.
  CellMapBounds bounds(bool& is_loose);
  CellMapBounds refined_bounds(int depth);
  /// Vertices begin, ..., end - 1 of the mesh are the first points of the result. Rounding that GridMap::rounding_of
  /// does not know goes to `rounding`.
  const PointColumns& place(const TileMesh& mesh, std::uint32_t begin, std::uint32_t end,
                            const WallNumbers& numbers, Greatest& rounding);

 private:
  const CellMap& interval_map();

  const GridMap& map_;
  std::array<std::size_t, 3> at_{};
  std::vector<double> row_;
  RoundedCell rounded_;
  PointColumns points_;
  // Made when it is used.
  bool has_interval_row_ = false, has_interval_cell_ = false;
  CageRow interval_row_;
  std::optional<CellMap> interval_cell_;
};

}  // namespace veritope::internal
