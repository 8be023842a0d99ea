// SPDX-License-Identifier: LGPL-3.0-or-later
// render/chain_cells.h: tetrahedra, and wedges between two Bezier triangles, with numbers on them, for viewers: VTK's
// unstructured grids with Bezier cells.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "robust/rational.h"
#include "splines/bezier_triangle.h"

namespace veritope {

/// What is known of a cell.
struct ChainCellValues {
  std::int64_t kind = 0;         ///< 0: a simplex; 1: a free-form cell
  std::int64_t coefficient = 0;  ///< 1 or -1; 0 for a cell whose patch is on both sides of its base
  std::uint64_t patch = 0;
};

class ChainCells {
 public:
  /// @error kNotFinite for a coordinate beyond binary64, kOverLimit for more than 2^25 points
  Status add_tetrahedron(const std::array<std::array<Rational, 3>, 4>& corners,
                         const ChainCellValues& values);
  /// What lies on straight lines between points with the same parameters of the triangle between `corners` and of
  /// `top`, which is homogeneous if it is rational; the lower triangle has its weights. @error likewise
  Status add_wedge(const std::array<std::array<Rational, 3>, 3>& corners,
                   const BezierTriangle<Rational>& top, const ChainCellValues& values);

  std::uint64_t num_cells() const { return num_cells_; }
  /// A .vtu file in ASCII.
  std::string vtu_bytes() const;

 private:
  Status add_point(const std::array<Rational, 3>& p, const Rational& weight);
  void close_cell(const std::array<int, 3>& degrees, int type, const ChainCellValues& values);

  std::uint64_t num_points_ = 0, num_cells_ = 0;
  std::string points_, weights_, connectivity_, offsets_, types_, degrees_, kinds_, coefficients_,
      patches_;
};

/// The number of control point (i, j) at the lower end (k = 0) or the upper one (k = 1) of a Bezier wedge of degrees
/// (n, n, 1) in VTK's order: the corners (0,0), (n,0), (0,n) of both ends, their edges in this order, their interiors
/// row by row. Source: VTK 9.1, vtkHigherOrderWedge::PointIndexFromIJK. REQUIRES i, j >= 0, i + j <= n, n >= 1.
std::size_t vtk_wedge_index(int i, int j, int k, int n);

}  // namespace veritope
