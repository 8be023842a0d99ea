// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/fill_cage.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "solids/micro/micro_grid.h"
#include "solids/micro/wall_pairs.h"

namespace veritope {
namespace {

constexpr unsigned kAllArms = 63;
constexpr std::int32_t kNoNumber = -1;

// The tiles with fewer arms, as they are needed.
class TileKinds {
 public:
  TileKinds(const std::vector<TileOfArms>& make, std::vector<MicroTile>& tiles)
      : make_(make), tiles_(tiles) {}
  // 1 more than the number of the tile.
  Result<std::uint8_t> with_arms(std::size_t choice, unsigned arms) {
    const auto [at, is_new] = numbers_.try_emplace({choice, arms}, std::uint8_t{0});
    if (!is_new) return at->second;
    Result<MicroTile> tile = make_[choice](arms);
    if (!tile) return tile.error();
    for (std::size_t k = 0; k < tiles_.size(); ++k)
      if (tiles_[k] == *tile) return at->second = static_cast<std::uint8_t>(k + 1);
    if (tiles_.size() == kMaxMicroTiles)
      return Error{
          Code::kOverLimit, {}, "more than " + std::to_string(kMaxMicroTiles) + " different tiles"};
    tiles_.push_back(std::move(*tile));
    return at->second = static_cast<std::uint8_t>(tiles_.size());
  }

 private:
  const std::vector<TileOfArms>& make_;
  std::vector<MicroTile>& tiles_;
  std::map<std::pair<std::size_t, unsigned>, std::uint8_t> numbers_;
};

// The walls of a cell that do not lie in collapsed faces.
unsigned arms_of(const VVolume& volume, const VModel& model, const MicroGrid& grid,
                 std::size_t cell) {
  const auto at = grid.shape().index_of(cell);
  unsigned arms = kAllArms;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t end = 0; end < 2; ++end) {
      const Rational& border =
          end == 0 ? volume.axis(a).domain_begin() : volume.axis(a).domain_end();
      if (grid.breaks[a][at[a] + end] == border &&
          model.face(grid.volume, 2 * a + end).is_collapsed())
        arms &= ~(1u << (2 * a + end));
    }
  return arms;
}

// Calls visit(wall, number) for the walls of a grid across an axis, and for each whether a cell beside it has a tile.
template <typename Visit>
void for_each_wall(MicroGrid& grid, std::uint32_t number, std::size_t axis, Visit visit) {
  const Grid<3> walls = grid.wall_shape(axis), cells = grid.shape();
  for (std::size_t w = 0; w < walls.count(); ++w) {
    GridWall wall{number, axis, walls.index_of(w)};
    bool is_used = wall.at[axis] < cells.size[axis] && grid.tiles[cells.at(wall.at)] != 0;
    if (wall.at[axis] > 0) {
      auto before = wall.at;
      --before[axis];
      is_used = is_used || grid.tiles[cells.at(before)] != 0;
    }
    visit(wall, is_used, grid.walls[axis][w]);
  }
}

GridWall grid_wall(const Microstructure& micro, const CellWall& w) {
  const auto axis = static_cast<std::size_t>(w.wall / 2);
  GridWall out{w.grid, axis, micro.grids[w.grid].shape().index_of(w.cell)};
  out.at[axis] += static_cast<std::size_t>(w.wall % 2);
  return out;
}
std::int32_t& number_at(Microstructure& micro, const GridWall& w) {
  MicroGrid& grid = micro.grids[w.grid];
  return grid.walls[w.axis][grid.wall_shape(w.axis).at(w.at)];
}
// A wall of 2 x 2 that lie in another wall of their volume.
bool is_quarter(const Microstructure& micro, const WallPair& pair) {
  const Rational half = Rational(1) / Rational(2);
  const WallPlacement& p = (*pair.placements)[1];
  return micro.grids[pair.walls[0].grid].volume == micro.grids[pair.walls[1].grid].volume &&
         !p.is_swapped && p.scale[0] == half && p.scale[1] == half;
}
bool is_whole_square(const WallPlacement& p) {
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_plain = p.scale[k] == Rational(1) && p.offset[k] == Rational(0);
    const bool is_turned = p.scale[k] == Rational(-1) && p.offset[k] == Rational(1);
    if (!is_plain && !is_turned) return false;
  }
  return true;
}

}  // namespace

Result<Microstructure> fill_cage(std::vector<VVolume> cage, const VModel& model,
                                 const std::array<std::uint64_t, 3>& counts, const TileOfArms& tile,
                                 std::uint64_t max_cells) {
  const auto first = [](const VVolume&, const MicroGrid&, std::uint64_t) {
    return Result<std::size_t>(0);
  };
  return fill_cage(std::move(cage), model, counts, std::vector<TileOfArms>{tile}, first, max_cells);
}

Result<Microstructure> fill_cage(std::vector<VVolume> cage, const VModel& model,
                                 const std::array<std::uint64_t, 3>& counts,
                                 const std::vector<TileOfArms>& tiles, const ChooseTile& choose,
                                 std::uint64_t max_cells) {
  Result<std::vector<MicroGrid>> grids = make_micro_grids(cage, {counts}, max_cells);
  if (!grids) return grids.error();
  return fill_grids(std::move(cage), model, std::move(*grids), tiles, choose);
}

Result<Microstructure> fill_grids(std::vector<VVolume> cage, const VModel& model,
                                  std::vector<MicroGrid> grids,
                                  const std::vector<TileOfArms>& tiles, const ChooseTile& choose) {
  Microstructure out;
  TileKinds kinds(tiles, out.tiles);
  for (MicroGrid& grid : grids)
    for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
      const VVolume& volume = cage[grid.volume];
      const Result<std::size_t> choice = choose(volume, grid, c);
      if (!choice) return choice.error();
      const Result<std::uint8_t> kind = kinds.with_arms(*choice, arms_of(volume, model, grid, c));
      if (!kind) return kind.error();
      grid.tiles[c] = *kind;
    }
  out.grids = std::move(grids);
  out.cage = std::move(cage);
  if (out.has_walls())
    for (MicroGrid& grid : out.grids)
      for (std::size_t a = 0; a < 3; ++a) grid.walls[a].assign(grid.wall_shape(a).count(), 0);
  return out;
}

Status number_walls(const VModel& model,
                    const std::function<Result<std::int32_t>(const GridWall&)>& number,
                    Microstructure& micro) {
  for (MicroGrid& grid : micro.grids)
    for (auto& walls : grid.walls) std::fill(walls.begin(), walls.end(), kNoNumber);
  std::optional<Error> error;
  for_each_wall_pair(micro, model, [&](const WallPair& pair) {
    if (pair.has_shared_number) return true;
    if (!is_whole_square((*pair.placements)[1]) && !is_quarter(micro, pair)) return true;
    const GridWall wall = grid_wall(micro, pair.walls[0]);
    std::int32_t& first = number_at(micro, wall);
    if (first == kNoNumber) {
      const Result<std::int32_t> n = number(wall);
      if (!n) error = n.error();
      if (error.has_value()) return false;
      first = *n;
    }
    number_at(micro, grid_wall(micro, pair.walls[1])) = first;
    return true;
  });
  for (std::uint32_t g = 0; g < micro.grids.size(); ++g)
    for (std::size_t a = 0; a < 3; ++a)
      for_each_wall(micro.grids[g], g, a, [&](const GridWall& wall, bool is_used, std::int32_t& n) {
        if (!is_used) n = 0;
        if (n != kNoNumber || error.has_value()) return;
        const Result<std::int32_t> found = number(wall);
        if (found)
          n = *found;
        else
          error = found.error();
      });
  if (error.has_value()) return *error;
  return ok_status();
}

void clear_unused_walls(Microstructure& micro) {
  if (!micro.has_walls()) return;
  for (std::uint32_t g = 0; g < micro.grids.size(); ++g)
    for (std::size_t a = 0; a < 3; ++a)
      for_each_wall(micro.grids[g], g, a, [](const GridWall&, bool is_used, std::int32_t& n) {
        if (!is_used) n = 0;
      });
}

std::array<Rational, 3> middle_of(const Microstructure& micro, const GridWall& wall) {
  const MicroGrid& grid = micro.grids[wall.grid];
  std::array<Rational, 3> out;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& breaks = grid.breaks[a];
    out[a] = a == wall.axis ? breaks[wall.at[a]]
                            : (breaks[wall.at[a]] + breaks[wall.at[a] + 1]) / Rational(2);
  }
  return out;
}

}  // namespace veritope
