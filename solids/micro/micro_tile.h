// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/micro_tile.h: tiles of microstructures: closed surfaces in the unit cube whose patches depend on
// numbers of the cube's walls. The format and its limits: docs/formats/micro-files.md. Nothing here is proved to be a
// solid: see tile_analysis.h.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robust/rational.h"

namespace veritope {

inline constexpr int kMaxTileDegree = 7;          ///< of a patch, along each axis
inline constexpr std::size_t kMaxTilePowers = 4;  ///< of the number of a wall: 1, t, t^2, t^3
inline constexpr std::size_t kMaxTilePatches = 1024;
inline constexpr std::size_t kMaxMicroTiles = 15;  ///< different ones in a microstructure
inline constexpr int kMaxTileBits = 128;           ///< of a numerator or denominator
/// Numbers of walls count 2^-20, from 0 to 1.
inline constexpr int kWallBits = 20;
inline constexpr std::int32_t kMaxWallNumber = 1 << kWallBits;

using TilePoint = std::array<Rational, 3>;

/// A polynomial map of [0,1]^2 into the unit cube. Its Bernstein coefficients are points[0] + points[1] t + ...,
/// where t is the number of a wall. In an open tile the second degree may be 0: then the patch is a curve.
struct TilePatch {
  /// 2 axis + end of the wall whose number t is; nothing if there is only points[0].
  std::optional<int> wall;
  std::array<int, 2> degrees{1, 1};
  /// One list for each power of t, each of (p + 1)(q + 1) points, the second parameter fastest.
  std::vector<std::vector<TilePoint>> points;

  std::size_t num_points() const {
    return static_cast<std::size_t>(degrees[0] + 1) * static_cast<std::size_t>(degrees[1] + 1);
  }
  bool is_curve() const { return degrees[1] == 0; }
  friend bool operator==(const TilePatch&, const TilePatch&) = default;
};

/// A surface whose normals S_u x S_v point outward; or, if it is open, any curves and sheets.
struct MicroTile {
  std::string name;
  /// The least and greatest number of a wall, in 2^-20; nothing if no patch depends on one.
  std::optional<std::array<std::int32_t, 2>> range;
  std::vector<TilePatch> patches;
  /// Curves and sheets, which bound nothing: no file of a microstructure holds such a tile (open_tile.h).
  bool is_open = false;

  friend bool operator==(const MicroTile&, const MicroTile&) = default;
};

/// The numbers of the walls of a cell, by 2 axis + end, in 2^-20.
using WallNumbers = std::array<std::int32_t, 6>;

/// The Bernstein coefficients of a patch for the number t = number / 2^20 of its wall, if it has one.
std::vector<TilePoint> points_at(const TilePatch& patch, std::int32_t number);
/// The number on which the patch depends; 0 if it depends on none.
inline std::int32_t number_of(const TilePatch& patch, const WallNumbers& numbers) {
  return patch.wall.has_value() ? numbers[static_cast<std::size_t>(*patch.wall)] : 0;
}

}  // namespace veritope
