// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/microstructure.h: tiles in the cells of grids in the parameters of a cage: a microstructure as its
// file has it (docs/formats/micro-files.md). Nothing is composed, and nothing is proved. Source: [HPE22], section 3.
// Design: docs/design/0071-microstructures.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/micro_bridge.h"
#include "solids/micro/micro_tile.h"
#include "solids/vmodel/v_model.h"
#include "splines/grid.h"

namespace veritope {

inline constexpr std::size_t kMaxMicroGrids = 65536;  ///< also the most volumes of a cage
inline constexpr std::size_t kMaxGridsOfVolume = 4096;
inline constexpr std::size_t kMaxBreakBits = 2048;  ///< of a numerator or denominator
inline constexpr std::uint64_t kMaxMicroCells = std::uint64_t{1} << 27;

/// Cells in a box of the parameters of a volume, and what they hold.
struct MicroGrid {
  std::uint32_t volume = 0;
  std::array<std::vector<Rational>, 3>
      breaks;  ///< rising, at least two; all knots between are among them
  /// 0 for an empty cell, else 1 more than the number of its tile; the last axis fastest.
  std::vector<std::uint8_t> tiles;
  /// By axis: numbers of the walls across it, in 2^-20; empty if no tile of the microstructure depends on them.
  std::array<std::vector<std::int32_t>, 3> walls;

  /// The number of intervals along each axis.
  Grid<3> shape() const {
    Grid<3> g;
    for (std::size_t a = 0; a < 3; ++a) g.size[a] = breaks[a].size() - 1;
    return g;
  }
  /// The walls across an axis, in the order of `walls`: one more along this axis than cells.
  Grid<3> wall_shape(std::size_t axis) const {
    Grid<3> g = shape();
    ++g.size[axis];
    return g;
  }
  /// The corners of cells: one more along each axis than cells.
  Grid<3> corner_shape() const {
    Grid<3> g = shape();
    for (std::size_t& n : g.size) ++n;
    return g;
  }
  /// All 0 if there are no numbers. REQUIRES a cell (i, j, k) of the grid.
  WallNumbers numbers_of(const std::array<std::size_t, 3>& cell) const;
};

/// The solid for which a microstructure was made.
struct MicroModelName {
  std::string name;
  std::string sha256;  ///< 64 lower-case hexadecimal digits
  friend bool operator==(const MicroModelName&, const MicroModelName&) = default;
};

inline constexpr std::size_t kMaxMicroMaterials = 16;
inline constexpr std::int64_t kMaxMaterialNumber = (std::int64_t{1} << 52) - 1;

/// A property of the points: trilinear in each cell, continuous across walls of one grid.
struct MicroMaterial {
  std::string name;
  /// By grids: the values at the corners of cells, in 2^-20, one more than cells along each axis, the last one fastest.
  std::vector<std::vector<std::int64_t>> values;
  friend bool operator==(const MicroMaterial&, const MicroMaterial&) = default;
};

struct Microstructure {
  std::optional<MicroModelName> model;
  std::vector<VVolume> cage;
  std::vector<MicroGrid> grids;  ///< by ascending volumes
  std::vector<MicroTile> tiles;
  std::vector<MicroBridge> bridges;  ///< by ascending caps
  std::vector<MicroSweep> sweeps;    ///< by ascending caps; empty if bridges is not
  std::vector<MicroMaterial> materials;

  /// Those in the parameters of the cage and those in space.
  std::size_t num_bridges() const { return bridges.size() + sweeps.size(); }
  bool has_walls() const {
    for (const MicroTile& tile : tiles)
      if (tile.range.has_value()) return true;
    return false;
  }
};

/// What docs/formats/micro-files.md demands of the parts, from numbers of tiles and degrees to breaks and walls.
/// @error kBadArgument, kOverLimit: the message names grid, axis, tile or patch, and the value
Status validate(const Microstructure& micro);

}  // namespace veritope
