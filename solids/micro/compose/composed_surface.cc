// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/compose/composed_surface.h"

#include <algorithm>
#include <string>
#include <utility>

#include "solids/micro/cap_matching.h"
#include "solids/micro/cell_piece.h"
#include "splines/composition_integer.h"

namespace veritope {
namespace {

BezierSurface<Rational> patch_in_piece(const CellPiece& piece, const TilePatch& patch,
                                       std::int32_t number) {
  const std::vector<TilePoint> points = points_at(patch, number);
  BezierSurface<Rational> out(patch.degrees, 3, false);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t n = 0; n < points.size(); ++n)
      out.component(static_cast<int>(a))[n] = piece.brought(a, points[n][a]);
  return out;
}

// The surface with its first parameter reversed: its normals turn round.
BezierSurface<Rational> turned_round(const BezierSurface<Rational>& s) {
  BezierSurface<Rational> out = s;
  const Grid<2> grid = s.grid();
  for (int c = 0; c < s.num_components(); ++c)
    for (std::size_t i = 0; i < grid.size[0]; ++i)
      for (std::size_t j = 0; j < grid.size[1]; ++j)
        out.component(c)[grid.at({i, j})] = s.component(c)[grid.at({grid.size[0] - 1 - i, j})];
  return out;
}

}  // namespace

Result<ComposedSurface> ComposedSurface::make(const Microstructure& micro, const VModel& cage,
                                              const std::vector<AnalysedTile>& tiles) {
  ComposedSurface out(micro, cage, tiles);
  if (Status status = out.find_cells(); !status) return status.error();
  if (Status status = out.count(); !status) return status.error();
  return out;
}

Status ComposedSurface::find_cells() {
  std::vector<std::vector<std::uint32_t>> numbers;
  for (std::uint32_t g = 0; g < micro_->grids.size(); ++g) {
    const MicroGrid& grid = micro_->grids[g];
    auto& of_grid = numbers.emplace_back(grid.tiles.size(), 0);
    for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
      if (grid.tiles[c] == 0) continue;
      of_grid[c] = static_cast<std::uint32_t>(cells_.size());
      cells_.push_back({g, grid.tiles[c] - 1u, c, 0});
    }
  }
  const bool has_caps = std::any_of(tiles_->begin(), tiles_->end(),
                                    [](const AnalysedTile& t) { return !t.caps.empty(); });
  if (!has_caps) return ok_status();
  CapMatcher matcher(*tiles_);
  Status found = ok_status();
  const bool is_complete = for_each_wall_pair(*micro_, *cage_, [&](const WallPair& pair) {
    std::array<ComposedCell*, 2> cells{};
    std::array<WallNumbers, 2> walls{};
    for (std::size_t side = 0; side < 2; ++side) {
      const CellWall& w = pair.walls[side];
      const MicroGrid& grid = micro_->grids[w.grid];
      cells[side] = &cells_[numbers[w.grid][w.cell]];
      walls[side] = grid.numbers_of(grid.shape().index_of(w.cell));
    }
    const std::array<std::uint32_t, 2> tiles = {cells[0]->tile, cells[1]->tile};
    const CapMatch* const for_all =
        pair.has_shared_number ? matcher.match_for_all(pair, tiles) : nullptr;
    const CapMatch match = for_all != nullptr ? *for_all : matcher.match(pair, tiles, walls);
    if (match.clash.has_value()) {
      found = bad_argument("a cap in wall " + name_of_wall(*micro_, pair.walls[0]) +
                           " and one in wall " + name_of_wall(*micro_, pair.walls[1]) +
                           " are neither equal nor apart");
      return false;
    }
    for (const auto& caps : match.equal)
      for (std::size_t side = 0; side < 2; ++side)
        cells[side]->glued_caps |= std::uint64_t{1} << caps[side];
    return true;
  });
  if (found && !is_complete)
    return Error{
        Code::kOverLimit,
        {},
        "more than " + std::to_string(kMaxWallMeetings) + " pairs of walls meet between grids"};
  return found;
}

bool ComposedSurface::is_left_out(const ComposedCell& cell, std::size_t patch) const {
  const std::uint32_t cap = (*tiles_)[cell.tile].cap_of_patch[patch];
  return cap != AnalysedTile::kNoCap && (cell.glued_caps >> cap & 1) != 0;
}

Status ComposedSurface::count() {
  for (const ComposedCell& cell : cells_) {
    const VVolume& volume = micro_->cage[micro_->grids[cell.grid].volume];
    const std::array<int, 3> outer = {volume.axis(0).degree, volume.axis(1).degree,
                                      volume.axis(2).degree};
    const auto& patches = (*tiles_)[cell.tile].tile.patches;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (is_left_out(cell, p)) continue;
      const std::array<int, 2> degrees = composed_degrees(outer, patches[p].degrees);
      if (std::max(degrees[0], degrees[1]) > kMaxSplineDegree)
        return Error{Code::kOverLimit,
                     {},
                     "patch " + std::to_string(p) + " of tile " + (*tiles_)[cell.tile].tile.name +
                         " in volume " + std::to_string(micro_->grids[cell.grid].volume) +
                         " would have degree " + std::to_string(std::max(degrees[0], degrees[1])) +
                         " after composition, and splines have at most " +
                         std::to_string(kMaxSplineDegree)};
      ++num_patches_;
      num_curves_ += patches[p].is_curve();
      num_points_ +=
          static_cast<std::uint64_t>(degrees[0] + 1) * static_cast<std::uint64_t>(degrees[1] + 1);
    }
  }
  return ok_status();
}

std::vector<std::vector<ComposedPatch>> ComposedSurface::compose(std::size_t begin,
                                                                 std::size_t end) const {
  std::vector<std::vector<ComposedPatch>> out;
  CellPiece piece(*micro_);
  for (std::size_t n = begin; n < end; ++n) {
    const ComposedCell& cell = cells_[n];
    const MicroGrid& grid = micro_->grids[cell.grid];
    const auto at = grid.shape().index_of(cell.cell);
    const WallNumbers numbers = grid.numbers_of(at);
    const bool is_left_handed = cage_->hand(grid.volume) == Sign::kNegative;
    piece.enter(cell.grid, at);
    auto& patches = out.emplace_back();
    const MicroTile& tile = (*tiles_)[cell.tile].tile;
    for (std::uint32_t p = 0; p < tile.patches.size(); ++p) {
      if (is_left_out(cell, p)) continue;
      const BezierSurface<Rational> inner =
          patch_in_piece(piece, tile.patches[p], number_of(tile.patches[p], numbers));
      BezierSurface<Rational> surface = compose_by_integers(piece.map(), inner).value();
      patches.push_back(
          {p, is_left_handed && !tile.is_open ? turned_round(surface) : std::move(surface)});
    }
  }
  return out;
}

}  // namespace veritope
