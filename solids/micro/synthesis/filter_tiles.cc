// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/synthesis/filter_tiles.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "robust/base/check.h"

namespace veritope {
namespace {

std::shared_ptr<const TileShape> shape_of(const MicroTile& tile, const WallNumbers& numbers) {
  std::vector<TileShape::Surface> patches;
  for (const TilePatch& patch : tile.patches) {
    std::vector<Rational> all;
    const std::vector<TilePoint> points = points_at(patch, number_of(patch, numbers));
    for (std::size_t c = 0; c < 3; ++c)
      for (const TilePoint& p : points) all.push_back(p[c]);
    patches.emplace_back(patch.degrees, 3, false, std::move(all));
  }
  Result<TileShape> shape =
      tile.is_open ? TileShape::make_open(std::move(patches)) : TileShape::make(std::move(patches));
  VT_CHECK(shape.has_value(), "the tile was checked");
  return std::make_shared<const TileShape>(std::move(*shape));
}

// The shapes of the tiles of one grid; a tile that depends on no number has one.
class GridShapes {
 public:
  GridShapes(const Microstructure& micro, const MicroGrid& grid)
      : micro_(micro), grid_(grid), cells_(grid.shape()) {
    for (const MicroTile& tile : micro.tiles)
      fixed_.push_back(tile.range.has_value() ? nullptr : shape_of(tile, {}));
  }
  std::shared_ptr<const TileShape> of(const std::array<std::uint32_t, 3>& cell) const {
    const std::array<std::size_t, 3> at = {cell[0], cell[1], cell[2]};
    // An empty cell has a status, too, which is not used.
    const std::size_t tile = std::max<std::size_t>(grid_.tiles[cells_.at(at)], 1) - 1;
    if (fixed_[tile] != nullptr) return fixed_[tile];
    WallNumbers numbers = grid_.numbers_of(at);
    if (grid_.tiles[cells_.at(at)] == 0) numbers.fill((*micro_.tiles[tile].range)[0]);
    return shape_of(micro_.tiles[tile], numbers);
  }

 private:
  const Microstructure& micro_;
  const MicroGrid& grid_;
  Grid<3> cells_;
  std::vector<std::shared_ptr<const TileShape>> fixed_;
};

}  // namespace

Result<std::vector<GridStatus>> filter_tiles_to(const TileFilter& filter, unsigned jobs,
                                                Microstructure& micro) {
  std::vector<GridStatus> out;
  for (MicroGrid& grid : micro.grids) {
    const GridShapes shapes(micro, grid);
    Result<GridStatus> found = filter_grid(
        filter, micro.cage[grid.volume], grid.breaks,
        [&](const std::array<std::uint32_t, 3>& cell) { return shapes.of(cell); }, jobs);
    if (!found) return found.error();
    for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
      if (grid.tiles[c] == 0) found->status[c] = CellStatus::kOutside;
      if (found->status[c] != CellStatus::kKept) grid.tiles[c] = 0;
    }
    found->counts = {};
    for (const CellStatus s : found->status) ++found->counts[static_cast<std::size_t>(s)];
    out.push_back(std::move(*found));
  }
  return out;
}

}  // namespace veritope
