// SPDX-License-Identifier: LGPL-3.0-or-later
// render/cell_grid.h: boxes and triangles with numbers on them, for viewers: VTK's unstructured grids.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// Cells of one kind.
struct CellGrid {
  enum class Kind { kHexahedra, kTriangles } kind = Kind::kHexahedra;
  std::vector<Point3d> points;
  std::vector<std::uint32_t> corners;  ///< 8 or 3 a cell, in VTK's order
  /// Names (letters, digits, _) and one value a cell.
  std::vector<std::pair<std::string, std::vector<std::int64_t>>> values;
  /// Red, green, blue and opacity, one a cell, or none; ParaView and VTK show them as they are.
  std::vector<std::array<std::uint8_t, 4>> colours;
  /// A list of texts beside the cells, under a name (letters, digits, _); none: no list.
  std::pair<std::string, std::vector<std::string>> texts;

  std::size_t corners_per_cell() const { return kind == Kind::kHexahedra ? 8 : 3; }
  std::size_t num_cells() const { return corners.size() / corners_per_cell(); }
  /// REQUIRES kind == kHexahedra.
  void add_box(const Box3d& box);
};
CellGrid triangle_grid(const TriangleMesh& mesh);

/// The 12 triangles of each box, outward.
TriangleMesh box_mesh(const std::vector<Box3d>& boxes);

/// A .vtu file in ASCII; coordinates as shortest decimals that read back as the same binary64. REQUIRES finite
/// coordinates, values of num_cells() each.
std::string vtu_bytes(const CellGrid& grid);

}  // namespace veritope
