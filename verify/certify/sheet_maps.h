// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/sheet_maps.h: the tensor forms of patches in doubles, for searches.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "solids/pieces/piece_forest.h"
#include "splines/bezier.h"

namespace veritope {

/// A place in the tensor form of a patch.
struct SheetPlace {
  std::uint32_t patch = 0;
  std::array<double, 2> at{};
};

/// The parameters of two places are numbered 0 to 3.
inline double& parameter(std::array<SheetPlace, 2>* places, std::size_t i) {
  return (*places)[i / 2].at[i % 2];
}
inline double parameter(const std::array<SheetPlace, 2>& places, std::size_t i) {
  return places[i / 2].at[i % 2];
}

/// Made on demand. Keeps a reference to the forest.
class SheetMaps {
 public:
  /// One patch in its tensor form; coordinates are as PieceForest has them relative to the origin.
  struct Sheet {
    BezierSurface<double> map;
    Point3d origin;
  };

  explicit SheetMaps(const PieceForest& forest) : forest_(forest) {}
  const PieceForest& forest() const { return forest_; }
  const Sheet& sheet(std::uint32_t patch);

 private:
  const PieceForest& forest_;
  std::unordered_map<std::uint32_t, Sheet> sheets_;
};

}  // namespace veritope
