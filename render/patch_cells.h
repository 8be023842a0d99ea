// SPDX-License-Identifier: LGPL-3.0-or-later
// render/patch_cells.h: many Bezier surfaces for viewers, written in parts: VTK's unstructured grids with Bezier cells.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "robust/rational.h"
#include "splines/bezier.h"

namespace veritope {

/// Surfaces whose second degree is 0 are curves. A .vtu file in ASCII: begin(), the points of all parts, and end().
/// Numbers are rounded to the nearest binary64.
/// Several threads may make parts; they are taken in order.
class PatchCells {
 public:
  /// Names of integers that each cell has (letters, digits, _).
  explicit PatchCells(std::vector<std::string> names) : names_(std::move(names)) {}

  class Part {
   public:
    /// REQUIRES a surface in space, and a value for each name. @error kNotFinite: a coordinate beyond binary64
    Status add(const BezierSurface<Rational>& surface, const std::vector<std::int64_t>& values);

   private:
    friend class PatchCells;
    struct Cell {
      std::array<int, 2> degrees;
      bool is_rational;
    };
    std::string points_;
    std::vector<double> weights_;  // of rational cells, point by point
    std::vector<Cell> cells_;
    std::vector<std::int64_t> values_;
  };

  static std::string begin(std::uint64_t num_points, std::uint64_t num_cells);
  /// The text of the part's points.
  std::string take(Part part);
  /// Writes what follows the points, in pieces. REQUIRES that as many points and cells were taken as begin() has.
  Status end(const std::function<Status(std::string_view)>& write) const;

 private:
  std::vector<std::string> names_;
  std::vector<Part::Cell> cells_;
  std::vector<double> weights_;
  std::vector<std::int64_t> values_;
};

}  // namespace veritope
