// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/microstructure.h"

namespace veritope {

WallNumbers MicroGrid::numbers_of(const std::array<std::size_t, 3>& cell) const {
  WallNumbers numbers{};
  for (std::size_t a = 0; a < 3; ++a) {
    if (walls[a].empty()) continue;
    const Grid<3> shape = wall_shape(a);
    const std::size_t begin = shape.at(cell);
    numbers[2 * a] = walls[a][begin];
    numbers[2 * a + 1] = walls[a][begin + shape.stride(a)];
  }
  return numbers;
}

}  // namespace veritope
