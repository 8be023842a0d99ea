// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/compose/composed_surface.h"

#include <algorithm>
#include <string>
#include <utility>

#include "solids/micro/bridge_faces.h"
#include "solids/micro/cap_matching.h"
#include "solids/micro/cell_piece.h"
#include "solids/micro/compose/bridge_piece_internal.h"
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

BezierSurface<Rational> face_in_piece(const internal::SpanPiece& piece,
                                      BezierSurface<Rational> face) {
  for (std::size_t a = 0; a < 3; ++a)
    for (Rational& x : face.component(static_cast<int>(a))) x = piece.brought(a, x);
  return face;
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

// The class has members of types that are complete here only.
ComposedSurface::ComposedSurface(const Microstructure& micro, const VModel& cage,
                                 const std::vector<AnalysedTile>& tiles)
    : micro_(&micro), cage_(&cage), tiles_(&tiles) {}
ComposedSurface::ComposedSurface(ComposedSurface&&) noexcept = default;
ComposedSurface::~ComposedSurface() = default;

Status ComposedSurface::find_cells() {
  std::vector<std::vector<std::uint32_t>> numbers;
  for (std::uint32_t g = 0; g < micro_->grids.size(); ++g) {
    const MicroGrid& grid = micro_->grids[g];
    auto& of_grid = numbers.emplace_back(grid.tiles.size(), 0);
    for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
      if (grid.tiles[c] == 0) continue;
      of_grid[c] = static_cast<std::uint32_t>(cells_.size());
      cells_.push_back({g, grid.tiles[c] - 1u, c, 0, {}});
    }
  }
  Status covered = cover_equal_caps(numbers);
  if (covered) covered = cover_bridged_caps(numbers);
  return covered ? cover_swept_caps(numbers) : covered;
}

Status ComposedSurface::cover_swept_caps(const std::vector<std::vector<std::uint32_t>>& numbers) {
  for (std::uint32_t s = 0; s < micro_->sweeps.size(); ++s) {
    const CapPlace& place = micro_->sweeps[s].cap;
    ComposedCell& cell = cells_[numbers[place.grid][place.cell]];
    const AnalysedTile& tile = (*tiles_)[cell.tile];
    const auto& caps = tile.caps_of_wall[static_cast<std::size_t>(place.wall)];
    if (caps.size() != 1 || tile.caps[caps.front()].patches.size() != 1)
      return bad_argument("sweep " + std::to_string(s) +
                          " starts at a wall that does not hold one cap of one patch");
    cell.covered_caps |= std::uint64_t{1} << caps.front();
    cell.bridges.push_back(s);
  }
  return ok_status();
}
const TilePatch& ComposedSurface::patch_of_sweep(std::uint32_t number) const {
  const CapPlace& place = micro_->sweeps[number].cap;
  const AnalysedTile& tile = (*tiles_)[micro_->grids[place.grid].tiles[place.cell] - 1u];
  const std::uint32_t cap = tile.caps_of_wall[static_cast<std::size_t>(place.wall)].front();
  return tile.tile.patches[tile.caps[cap].patches.front()];
}

Status ComposedSurface::cover_equal_caps(const std::vector<std::vector<std::uint32_t>>& numbers) {
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
        cells[side]->covered_caps |= std::uint64_t{1} << caps[side];
    return true;
  });
  if (found && !is_complete)
    return Error{
        Code::kOverLimit,
        {},
        "more than " + std::to_string(kMaxWallMeetings) + " pairs of walls meet between grids"};
  return found;
}

Status ComposedSurface::cover_bridged_caps(const std::vector<std::vector<std::uint32_t>>& numbers) {
  if (micro_->bridges.empty()) return ok_status();
  for (const VVolume& volume : micro_->cage) pieces_.emplace_back(volume);
  for (std::uint32_t b = 0; b < micro_->bridges.size(); ++b) {
    const MicroBridge& bridge = micro_->bridges[b];
    const BezierVolume<Rational> map = bridge_map(bridge);
    TilePoint lo, hi;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto x = map.component(static_cast<int>(a));
      const auto [least, most] = std::minmax_element(x.begin(), x.end());
      lo[a] = *least;
      hi[a] = *most;
    }
    span_of_bridge_.push_back(pieces_[bridge.volume].span_around(lo, hi));
    if (!span_of_bridge_.back()) {
      left_out_.push_back(b);
      continue;
    }
    ComposedCell& cell = cells_[numbers[bridge.cap.grid][bridge.cap.cell]];
    const auto& caps = (*tiles_)[cell.tile].caps_of_wall[static_cast<std::size_t>(bridge.cap.wall)];
    if (caps.size() != 1)
      return bad_argument("bridge " + std::to_string(b) + " starts at a wall with " +
                          std::to_string(caps.size()) + " caps");
    cell.covered_caps |= std::uint64_t{1} << caps.front();
    cell.bridges.push_back(b);
  }
  return ok_status();
}

bool ComposedSurface::is_left_out(const ComposedCell& cell, std::size_t patch) const {
  const std::uint32_t cap = (*tiles_)[cell.tile].cap_of_patch[patch];
  return cap != AnalysedTile::kNoCap && (cell.covered_caps >> cap & 1) != 0;
}

Status ComposedSurface::count_patch(std::uint32_t volume, const std::array<int, 2>& degrees,
                                    const std::string& name) {
  const std::array<int, 2> composed = degrees_after(volume, degrees);
  if (std::max(composed[0], composed[1]) > kMaxSplineDegree)
    return Error{Code::kOverLimit,
                 {},
                 name + " in volume " + std::to_string(volume) + " would have degree " +
                     std::to_string(std::max(composed[0], composed[1])) +
                     " after composition, and splines have at most " +
                     std::to_string(kMaxSplineDegree)};
  ++num_patches_;
  num_curves_ += degrees[1] == 0;
  num_points_ +=
      static_cast<std::uint64_t>(composed[0] + 1) * static_cast<std::uint64_t>(composed[1] + 1);
  return ok_status();
}

std::array<int, 2> ComposedSurface::degrees_after(std::uint32_t volume,
                                                  const std::array<int, 2>& degrees) const {
  const VVolume& map = micro_->cage[volume];
  return composed_degrees(
      std::array<int, 3>{map.axis(0).degree, map.axis(1).degree, map.axis(2).degree}, degrees);
}

// Those of a bridge or of a sweep.
Status ComposedSurface::count_faces(std::uint32_t number) {
  if (micro_->sweeps.empty()) {
    const MicroBridge& bridge = micro_->bridges[number];
    for (const BezierSurface<Rational>& face : free_faces(bridge))
      if (Status status = count_patch(bridge.volume, face.degrees(),
                                      "a face of bridge " + std::to_string(number));
          !status)
        return status;
    return ok_status();
  }
  const std::uint32_t volume = micro_->grids[micro_->sweeps[number].cap.grid].volume;
  const std::array<int, 2> cap = patch_of_sweep(number).degrees;
  // The end has the degrees of the cap; each of four sides has one of them.
  if (Status status = count_patch(volume, cap, "the end of sweep " + std::to_string(number));
      !status)
    return status;
  const std::array<int, 2> composed = degrees_after(volume, cap);
  num_patches_ += kFreeBridgeFaces - 1;
  for (const int degree : composed)
    num_points_ +=
        std::uint64_t{2} * (kBridgeAxisDegree + 1) * static_cast<std::uint64_t>(degree + 1);
  return ok_status();
}

Status ComposedSurface::count() {
  for (const ComposedCell& cell : cells_) {
    const MicroTile& tile = (*tiles_)[cell.tile].tile;
    for (std::size_t p = 0; p < tile.patches.size(); ++p) {
      if (is_left_out(cell, p)) continue;
      if (Status status = count_patch(micro_->grids[cell.grid].volume, tile.patches[p].degrees,
                                      "patch " + std::to_string(p) + " of tile " + tile.name);
          !status)
        return status;
    }
    for (const std::uint32_t b : cell.bridges)
      if (Status status = count_faces(b); !status) return status;
  }
  return ok_status();
}

std::vector<std::vector<ComposedPatch>> ComposedSurface::compose(std::size_t begin,
                                                                 std::size_t end) const {
  std::vector<std::vector<ComposedPatch>> out;
  CellPiece piece(*micro_);
  for (std::size_t n = begin; n < end; ++n) {
    compose_tile(cells_[n], piece, out.emplace_back());
    for (const std::uint32_t b : cells_[n].bridges)
      micro_->sweeps.empty() ? compose_bridge(b, out.back()) : compose_sweep(b, piece, out.back());
  }
  return out;
}

void ComposedSurface::compose_tile(const ComposedCell& cell, CellPiece& piece,
                                   std::vector<ComposedPatch>& out) const {
  const MicroGrid& grid = micro_->grids[cell.grid];
  const auto at = grid.shape().index_of(cell.cell);
  const WallNumbers numbers = grid.numbers_of(at);
  const bool is_left_handed = cage_->hand(grid.volume) == Sign::kNegative;
  piece.enter(cell.grid, at);
  const MicroTile& tile = (*tiles_)[cell.tile].tile;
  for (std::uint32_t p = 0; p < tile.patches.size(); ++p) {
    if (is_left_out(cell, p)) continue;
    const BezierSurface<Rational> inner =
        patch_in_piece(piece, tile.patches[p], number_of(tile.patches[p], numbers));
    BezierSurface<Rational> surface = compose_by_integers(piece.map(), inner).value();
    out.push_back({p, std::nullopt,
                   is_left_handed && !tile.is_open ? turned_round(surface) : std::move(surface)});
  }
}

// The piece is that of the cell.
void ComposedSurface::compose_sweep(std::uint32_t number, CellPiece& piece,
                                    std::vector<ComposedPatch>& out) const {
  const MicroSweep& sweep = micro_->sweeps[number];
  const MicroGrid& grid = micro_->grids[sweep.cap.grid];
  const TilePatch& patch = patch_of_sweep(number);
  const WallNumbers numbers = grid.numbers_of(grid.shape().index_of(sweep.cap.cell));
  const BezierSurface<Rational> image =
      compose_by_integers(piece.map(), patch_in_piece(piece, patch, number_of(patch, numbers)))
          .value();
  const bool is_left_handed = cage_->hand(grid.volume) == Sign::kNegative;
  std::uint32_t p = 0;
  for (BezierSurface<Rational>& face : free_faces(sweep_map(sweep, image)))
    out.push_back({p++, number, is_left_handed ? turned_round(face) : std::move(face)});
}

void ComposedSurface::compose_bridge(std::uint32_t number, std::vector<ComposedPatch>& out) const {
  const MicroBridge& bridge = micro_->bridges[number];
  const internal::SpanPiece piece = pieces_[bridge.volume].at(*span_of_bridge_[number]);
  const bool is_left_handed = cage_->hand(bridge.volume) == Sign::kNegative;
  std::uint32_t p = 0;
  for (BezierSurface<Rational>& face : free_faces(bridge)) {
    BezierSurface<Rational> surface =
        compose_by_integers(piece.map, face_in_piece(piece, std::move(face))).value();
    out.push_back({p++, number, is_left_handed ? turned_round(surface) : std::move(surface)});
  }
}

}  // namespace veritope
