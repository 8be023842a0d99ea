// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/micro_validity.h: what docs/formats/micro-files.md demands of the parts of a microstructure, one by
// one, so that a reader knows the line of what it refuses. All together: validate() of microstructure.h.
// @error of all functions: kBadArgument, kOverLimit; the message names the part and the value
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "solids/micro/microstructure.h"

namespace veritope {

/// Whether it has 64 lower-case hexadecimal digits.
bool is_sha256_text(std::string_view text);

/// A volume of the cage: a map to space with clamped axes and positive weights.
Status check_cage_volume(const VVolume& volume, std::size_t number);
Status check_tile(const MicroTile& tile, std::size_t number);
/// The volume and the breaks of a grid, and whether it comes after the grid before it. Adds its cells to `cells`,
/// those of the grids before it. REQUIRES check_cage_volume of all volumes, and cells <= kMaxMicroCells.
Status check_breaks(const Microstructure& micro, std::size_t grid, std::uint64_t& cells);
/// The first grid of a volume after kMaxGridsOfVolume others, if there is one. REQUIRES check_breaks of all grids.
std::optional<std::size_t> crowding_grid(const Microstructure& micro);
Status crowding_error(const Microstructure& micro, std::size_t grid);
/// Two grids of one volume whose boxes have a common inner point, the lower number first, if such grids exist.
/// REQUIRES check_breaks of all grids.
/// @cost  n log n comparisons of rationals and at most n^2 of integers, for n grids of one volume
std::optional<std::array<std::size_t, 2>> overlapping_grids(const Microstructure& micro);
Status overlap_error(const Microstructure& micro, const std::array<std::size_t, 2>& grids);
/// Which tile each cell holds. REQUIRES check_breaks of the grid.
Status check_cells(const Microstructure& micro, std::size_t grid);
/// The numbers of the walls across an axis. REQUIRES check_cells of the grid.
Status check_walls(const Microstructure& micro, std::size_t grid, std::size_t axis);
/// Whether the bridge starts at a wall of a cell with a tile, its volume exists, its net is as the page says, and its
/// cap comes after that of the bridge before it; not whether it starts as a cap. REQUIRES check_cells of all grids.
Status check_bridge(const Microstructure& micro, std::size_t bridge);
/// Whether the sweep starts at a wall of a cell with a tile, its axis is as the page says, its cap comes after that of
/// the sweep before it, and there are no bridges. REQUIRES check_cells of all grids.
Status check_sweep(const Microstructure& micro, std::size_t sweep);
/// REQUIRES check_breaks of all grids.
Status check_material(const Microstructure& micro, std::size_t material);

}  // namespace veritope
