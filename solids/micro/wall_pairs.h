// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/wall_pairs.h: which walls of the cells of a microstructure meet: inside of grids, between grids of one
// volume, and across glued faces of the cage. Section 6 of docs/certificates/microstructure.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solids/micro/microstructure.h"

namespace veritope {

/// A cell of a grid, and one of its walls, 2 axis + end.
struct CellWall {
  std::uint32_t grid = 0;
  std::uint64_t cell = 0;
  int wall = 0;
};

/// Where the square of a wall's parameters (its two axes, ascending, 0 to 1 in the cell) lies in those of a face:
/// coordinate k is offset[k] + scale[k] times parameter k, or 1 - k if is_swapped.
struct WallPlacement {
  bool is_swapped = false;
  std::array<Rational, 2> scale{Rational(1), Rational(1)}, offset{};
  friend bool operator==(const WallPlacement&, const WallPlacement&) = default;
};

/// Two walls with a common inner point, in the parameters of one face. If their rectangles are equal, these are
/// brought to [0, 1], and the first wall is placed as it is.
struct WallPair {
  std::array<CellWall, 2> walls;
  const std::array<WallPlacement, 2>* placements = nullptr;  ///< null: both as they are
  bool has_shared_number = false;  ///< they are one wall of a grid, with one number
};

/// The most pairs that do not lie in one grid.
inline constexpr std::uint64_t kMaxWallMeetings = std::uint64_t{1} << 24;

/// Calls visit for each pair of cells with tiles, the pairs in grids first, until it returns false. Returns false if
/// there are more than kMaxWallMeetings pairs of walls, with or without tiles, that do not lie in one grid; then the
/// visits are not complete.
/// REQUIRES that the cage is that of micro.
bool for_each_wall_pair(const Microstructure& micro, const VModel& cage,
                        const std::function<bool(const WallPair&)>& visit);

/// "u0 of cell (1, 0, 2) of grid 0".
std::string name_of_wall(const Microstructure& micro, const CellWall& wall);

}  // namespace veritope
