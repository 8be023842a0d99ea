// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/micro_tile.h"

namespace veritope {

std::vector<TilePoint> points_at(const TilePatch& patch, std::int32_t number) {
  std::vector<TilePoint> at = patch.points.back();
  const Rational t = Rational(number) * Rational::power_of_two(-kWallBits);
  for (std::size_t k = patch.points.size() - 1; k-- > 0;)
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) at[i][c] = at[i][c] * t + patch.points[k][i][c];
  return at;
}

}  // namespace veritope
