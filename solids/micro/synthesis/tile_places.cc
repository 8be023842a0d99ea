// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/synthesis/tile_places.h"

#include <string>
#include <vector>

#include "solids/micro/synthesis/formula_point_internal.h"

namespace veritope {

Result<std::size_t> TilePlaces::operator()(const VVolume& volume, const MicroGrid& grid,
                                           std::uint64_t cell) {
  const auto place = grid.shape().index_of(cell);
  const auto about = [&](const std::string& what) {
    return bad_argument("cell (" + std::to_string(place[0]) + ", " + std::to_string(place[1]) +
                        ", " + std::to_string(place[2]) + ") of volume " +
                        std::to_string(grid.volume) + ": " + what);
  };
  std::array<Rational, 3> middle;
  for (std::size_t a = 0; a < 3; ++a)
    middle[a] = (grid.breaks[a][place[a]] + grid.breaks[a][place[a] + 1]) / Rational(2);
  const Result<RoundedValue> value =
      evaluator_.round_to_multiple(internal::formula_values(formula_, volume, middle),
                                   (std::uint64_t{grid.volume} << 40) + cell);
  if (!value) return about(value.error().message);
  if (value->open.has_value()) return about(value->open->message);
  const std::int64_t number = value->multiple >> kWallBits;  // rounds down
  if (number < 0 || number >= static_cast<std::int64_t>(num_tiles_))
    return about("the value " + std::to_string(value->multiple) + "/2^20 is the number " +
                 std::to_string(number) + " of a tile, and there are " +
                 std::to_string(num_tiles_) + ", from 0");
  return static_cast<std::size_t>(number);
}

}  // namespace veritope
