// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/tile_family.h: all members of a patch at once: a volume whose third parameter is the number of a wall.
// The conditions of which it serves the proof: docs/certificates/microstructure.md, sections 4 and 5.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "solids/micro/micro_tile.h"
#include "splines/bezier.h"

namespace veritope {

/// S(u, v, t) in Bernstein form, with t from the least to the greatest number of the range brought to [0, 1]. Where
/// no number matters, or the range is one number, the degree along the third axis is 0.
BezierVolume<Rational> family_of(const TilePatch& patch,
                                 const std::optional<std::array<std::int32_t, 2>>& range);

/// The Bernstein coefficients of S_u x S_v . (S - a), of the degrees 3p - 1, 3q - 1 and three times that in t.
BezierVolume<Rational> star_product(const BezierVolume<Rational>& family, const TilePoint& a);

/// The height over wall 2 axis + end of the unit cube: x_axis, or 1 - x_axis.
BezierVolume<Rational> height_over(const BezierVolume<Rational>& family, int wall);

/// Side s of a patch runs from its corner s to its corner s + 1, counterclockwise, seen from outside: v = 0, u = 1, v
/// = 1, u = 0. Corners: (0, 0), (1, 0), (1, 1), (0, 1).
inline constexpr std::size_t kTileSides = 4;
/// The index of the i-th control point of a side, in its direction of travel, in a net of (p + 1) x (q + 1).
constexpr std::size_t tile_side_index(const std::array<int, 2>& degrees, std::size_t side,
                                      std::size_t i) {
  const auto p = static_cast<std::size_t>(degrees[0]), q = static_cast<std::size_t>(degrees[1]);
  const std::size_t row = side == 0 ? i : side == 1 ? p : side == 2 ? p - i : 0;
  const std::size_t column = side == 0 ? 0 : side == 1 ? i : side == 2 ? q : q - i;
  return row * (q + 1) + column;
}
/// The degree of the side as a curve.
constexpr int tile_side_degree(const std::array<int, 2>& degrees, std::size_t side) {
  return degrees[side % 2];
}

/// The side as a polynomial map of its parameter and of the numbers of walls, as a text that is equal for equal maps;
/// empty if the side is a point for each number. The text of the side passed backwards if `is_backwards`.
std::string side_key(const TilePatch& patch, std::size_t side, bool is_backwards);

}  // namespace veritope
