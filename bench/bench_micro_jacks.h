// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_micro_jacks.h: jacks with arms of different widths, in a straight and in a bent cage.
#pragma once
#include <cmath>
#include <cstdint>
#include <utility>

#include "solids/micro/jack.h"
#include "solids/micro/micro_grid.h"
#include "tests/support/v_cells.h"

namespace veritope::bench {

inline VVolume straight_cage() { return v_cells::cube(0, 0, 0); }
// The cube with control points moved by less than a tenth of their distance.
inline VVolume bent_cage() {
  return v_cells::polynomial({3, 3, 3}, [](std::size_t i, std::size_t j, std::size_t k) {
    const auto at = [](std::size_t n, std::size_t a, std::size_t b) {
      return Rational(10 * static_cast<std::int64_t>(n) +
                      static_cast<std::int64_t>((2 * a + 3 * b) % 3) - 1) /
             Rational(30);
    };
    return v_cells::Point{at(i, j, k), at(j, k, i), at(k, i, j)};
  });
}

inline Microstructure graded_jacks(VVolume cage, std::uint64_t n, int degree) {
  Microstructure out;
  MicroGrid grid = make_micro_grid(cage, 0, {n, n, n}).value();
  for (std::uint8_t& t : grid.tiles) t = 1;
  JackShape shape;
  shape.degree = degree;
  shape.range = {{kMaxWallNumber / 12, kMaxWallNumber / 6}};
  out.tiles.push_back(jack_tile(shape).value());
  for (std::size_t a = 0; a < 3; ++a) {
    const Grid<3> walls = grid.wall_shape(a);
    for (std::size_t w = 0; w < walls.count(); ++w) {
      const auto at = walls.index_of(w);
      const double wave = std::sin(0.3 * static_cast<double>(at[0] + 2 * at[1]) +
                                   0.17 * static_cast<double>(at[2] + a));
      grid.walls[a].push_back(static_cast<std::int32_t>(kMaxWallNumber * (0.125 + 0.04 * wave)));
    }
  }
  out.grids.push_back(std::move(grid));
  out.cage.push_back(std::move(cage));
  return out;
}

}  // namespace veritope::bench
