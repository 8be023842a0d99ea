// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/micro_cells.h: tiles and microstructures made by hand.
#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "solids/micro/jack.h"
#include "solids/micro/micro_grid.h"
#include "tests/support/v_cells.h"

namespace veritope::micro_cells {

/// All cells of all volumes hold tile 0; walls have the number `number`.
inline Microstructure full(std::vector<VVolume> cage, const std::array<std::uint64_t, 3>& counts,
                           MicroTile tile, std::int32_t number = 0) {
  Microstructure out;
  for (std::uint32_t v = 0; v < cage.size(); ++v) {
    MicroGrid grid = make_micro_grid(cage[v], v, counts).value();
    for (std::uint8_t& t : grid.tiles) t = 1;
    if (tile.range.has_value())
      for (std::size_t a = 0; a < 3; ++a) grid.walls[a].assign(grid.wall_shape(a).count(), number);
    out.grids.push_back(std::move(grid));
  }
  out.cage = std::move(cage);
  out.tiles.push_back(std::move(tile));
  return out;
}

/// A point in the unit cube, in sixty-fourths.
inline TilePoint at(int x, int y, int z) {
  const Rational unit = Rational(1) / Rational(64);
  return {Rational(x) * unit, Rational(y) * unit, Rational(z) * unit};
}
/// The bilinear patch with the corners (0, 0), (1, 0), (1, 1), (0, 1) of its parameters.
inline TilePatch square(const TilePoint& a, const TilePoint& b, const TilePoint& c,
                        const TilePoint& d) {
  TilePatch out;
  out.points = {{a, d, b, c}};
  return out;
}
/// A box with corners in sixty-fourths, its six faces outward.
inline MicroTile box_tile(const std::array<int, 3>& lo, const std::array<int, 3>& hi) {
  const auto corner = [&](int i, int j, int k) {
    return at(i == 0 ? lo[0] : hi[0], j == 0 ? lo[1] : hi[1], k == 0 ? lo[2] : hi[2]);
  };
  MicroTile out;
  out.name = "box";
  out.patches = {
      square(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)),
      square(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1)),
      square(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)),
      square(corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0)),
      square(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0)),
      square(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)),
  };
  return out;
}

/// A ring around the z-axis whose one volume is glued to itself along v.
inline VVolume ring_cage() {
  const std::array<std::array<int, 2>, 7> hexagon = {
      {{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}, {2, 0}}};
  return v_cells::polynomial({1, 6, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
    const int r = i == 0 ? 2 : 3;
    return v_cells::Point{Rational(r * hexagon[j][0]), Rational(r * hexagon[j][1]), Rational(k)};
  });
}

}  // namespace veritope::micro_cells
