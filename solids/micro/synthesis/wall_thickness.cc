// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/synthesis/wall_thickness.h"

#include <algorithm>
#include <string>
#include <vector>

#include "interval/formula/formula_evaluator.h"
#include "solids/micro/synthesis/formula_point_internal.h"
#include "solids/micro/wall_pairs.h"

namespace veritope {
namespace {

// A cell that has the wall: that before it at the end of a grid, else that after it.
CellWall cell_beside(const Microstructure& micro, const GridWall& w) {
  const Grid<3> shape = micro.grids[w.grid].shape();
  const bool is_last = w.at[w.axis] == shape.size[w.axis];
  std::array<std::size_t, 3> cell = w.at;
  if (is_last) --cell[w.axis];
  return {w.grid, shape.at(cell), static_cast<int>(2 * w.axis) + (is_last ? 1 : 0)};
}

class WallEvaluator {
 public:
  WallEvaluator(const RealFormula& formula, const std::array<std::int32_t, 2>& limits,
                const Microstructure& micro)
      : formula_(formula),
        evaluator_(formula),
        limits_(limits),
        micro_(micro),
        bounds_(micro.cage) {}

  Result<std::int32_t> operator()(const GridWall& wall) {
    if (const auto quick = round_within_bounds(wall))
      if (*quick >= limits_[0] && *quick <= limits_[1]) return static_cast<std::int32_t>(*quick);
    const Result<RoundedValue> value =
        evaluator_.round_to_multiple(values_at(wall), index_of(wall));
    if (!value) return about(wall, value.error().message);
    if (value->open.has_value()) return about(wall, value->open->message);
    if (value->multiple < limits_[0] || value->multiple > limits_[1])
      return about(wall, "the value " + std::to_string(value->multiple) + "/2^20 is not between " +
                             std::to_string(limits_[0]) + "/2^20 and " +
                             std::to_string(limits_[1]) + "/2^20");
    return static_cast<std::int32_t>(value->multiple);
  }

 private:
  Error about(const GridWall& wall, const std::string& what) const {
    return bad_argument("wall " + name_of_wall(micro_, cell_beside(micro_, wall)) + ": " + what);
  }
  std::optional<std::int64_t> round_within_bounds(const GridWall& wall) {
    const auto bounds = bounds_(formula_, micro_.grids[wall.grid].volume, middle_of(micro_, wall));
    if (!bounds) return std::nullopt;
    return evaluator_.round_within(*bounds, index_of(wall));
  }
  std::vector<Rational> values_at(const GridWall& wall) const {
    return internal::formula_values(formula_, micro_.cage[micro_.grids[wall.grid].volume],
                                    middle_of(micro_, wall));
  }
  // A number of its own for each wall, for rand.
  std::uint64_t index_of(const GridWall& wall) const {
    const Grid<3> shape = micro_.grids[wall.grid].wall_shape(wall.axis);
    return ((std::uint64_t{wall.grid} << 40) + shape.at(wall.at)) * 3 + wall.axis;
  }

  const RealFormula& formula_;
  FormulaEvaluator evaluator_;
  std::array<std::int32_t, 2> limits_;
  const Microstructure& micro_;
  internal::FormulaBoundsOfCage bounds_;
};

}  // namespace

Status number_walls_by(const RealFormula& formula, const VModel& model,
                       const std::array<std::int32_t, 2>& limits, Microstructure& micro) {
  WallEvaluator evaluator(formula, limits, micro);
  std::optional<std::array<std::int32_t, 2>> range;
  const Status status = number_walls(
      model,
      [&](const GridWall& wall) {
        Result<std::int32_t> n = evaluator(wall);
        if (n)
          range = range ? std::array{std::min((*range)[0], *n), std::max((*range)[1], *n)}
                        : std::array{*n, *n};
        return n;
      },
      micro);
  if (!status || !range.has_value()) return status;
  for (MicroTile& tile : micro.tiles)
    if (tile.range.has_value()) tile.range = range;
  return ok_status();
}

}  // namespace veritope
