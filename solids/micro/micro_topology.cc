// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/micro_topology.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "robust/base/disjoint_sets.h"

namespace veritope {
namespace {

class Topology {
 public:
  Topology(const Microstructure& micro, const VModel& cage, const std::vector<AnalysedTile>& tiles)
      : micro_(micro), cage_(cage), tiles_(tiles), matcher_(tiles) {
    std::uint64_t first = 0;
    for (const MicroGrid& g : micro.grids) {
      first_cell_.push_back(first);
      first += g.tiles.size();
    }
    counts_.cells = first;
    counts_.bridges = micro.num_bridges();
  }

  std::variant<MicroCounts, MicroDefect> run(std::vector<CellPatch>* first_patches = nullptr) {
    first_patches_ = first_patches;
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g)
      if (auto defect = grid_defect(g)) return std::move(*defect);
    glued_.assign(counts_.cells, 0);
    components_ = DisjointSets<>(counts_.cells);
    const bool is_complete = for_each_wall_pair(micro_, cage_, [&](const WallPair& pair) {
      with_match(pair, [&](const CapMatch& match) {
        if (match.clash.has_value()) defect_ = clash_of(pair, *match.clash);
        for (const auto& caps : match.equal) add_pair(pair, caps);
      });
      return !defect_.has_value();
    });
    if (defect_.has_value()) return std::move(*defect_);
    if (!is_complete)
      return MicroDefect{
          "T4",
          {},
          "more than " + std::to_string(kMaxWallMeetings) + " pairs of walls meet between grids"};
    count();
    return counts_;
  }

  // The cells with tiles off the largest component, by grids. REQUIRES that run() found no defect.
  std::vector<std::vector<std::uint64_t>> floating() {
    std::vector<std::uint32_t> sizes(counts_.cells);
    std::uint32_t largest = 0;
    for_each_tile([&](std::uint32_t, std::uint64_t, std::uint32_t root) {
      if (++sizes[root] > sizes[largest] || (sizes[root] == sizes[largest] && root < largest))
        largest = root;
    });
    return tiles_off([&](std::uint32_t root) { return root == largest; });
  }
  // The cells with tiles that are not joined to one with a bridge, by grids. REQUIRES that run() found no defect.
  std::vector<std::vector<std::uint64_t>> without_bridges() {
    std::vector<char> is_held(counts_.cells);
    const auto hold = [&](const CapPlace& cap) {
      is_held[components_.find(number_of_cell({cap.grid, cap.cell, 0}))] = 1;
    };
    for (const MicroBridge& b : micro_.bridges) hold(b.cap);
    for (const MicroSweep& s : micro_.sweeps) hold(s.cap);
    return tiles_off([&](std::uint32_t root) { return is_held[root] != 0; });
  }

 private:
  // Calls visit(grid, cell, component).
  template <typename Visit>
  void for_each_tile(Visit visit) {
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g)
      for (std::uint64_t c = 0; c < micro_.grids[g].tiles.size(); ++c)
        if (micro_.grids[g].tiles[c] != 0) visit(g, c, components_.find(number_of_cell({g, c, 0})));
  }

  template <typename Keeps>
  std::vector<std::vector<std::uint64_t>> tiles_off(Keeps keeps) {
    std::vector<std::vector<std::uint64_t>> out(micro_.grids.size());
    for_each_tile([&](std::uint32_t g, std::uint64_t c, std::uint32_t root) {
      if (!keeps(root)) out[g].push_back(c);
    });
    return out;
  }

  std::uint32_t number_of_cell(const CellWall& w) const {
    return static_cast<std::uint32_t>(first_cell_[w.grid] + w.cell);
  }
  std::uint32_t tile_of(const CellWall& w) const {
    return std::uint32_t{micro_.grids[w.grid].tiles[w.cell]} - 1;
  }
  WallNumbers numbers_of(const CellWall& w) const {
    const MicroGrid& g = micro_.grids[w.grid];
    return g.numbers_of(g.shape().index_of(w.cell));
  }

  std::optional<MicroDefect> grid_defect(std::uint32_t g) {
    const MicroGrid& grid = micro_.grids[g];
    for (std::uint64_t c = 0; c < grid.tiles.size(); ++c) {
      if (grid.tiles[c] == 0) continue;
      ++counts_.tiles;
      const AnalysedTile& tile = tiles_[grid.tiles[c] - 1u];
      if (auto defect = number_defect(tile, {g, c, 0})) return defect;
    }
    for (int wall = 0; wall < 6; ++wall)
      if (auto defect = collapse_defect(g, wall)) return defect;
    return std::nullopt;
  }
  // G1
  std::optional<MicroDefect> number_defect(const AnalysedTile& tile, CellWall at) const {
    if (!tile.tile.range.has_value()) return std::nullopt;
    const WallNumbers numbers = numbers_of(at);
    const auto [lo, hi] = *tile.tile.range;
    if (std::all_of(numbers.begin(), numbers.end(),
                    [lo = lo, hi = hi](std::int32_t k) { return lo <= k && k <= hi; }))
      return std::nullopt;
    for (const TilePatch& patch : tile.tile.patches) {
      if (!patch.wall.has_value()) continue;
      const std::int32_t k = numbers[static_cast<std::size_t>(*patch.wall)];
      if (lo <= k && k <= hi) continue;
      at.wall = *patch.wall;
      return MicroDefect{"G1",
                         {at},
                         "the number " + std::to_string(k) + " of wall " +
                             name_of_wall(micro_, at) + " is not in the range of its tile, " +
                             std::to_string(lo) + " to " + std::to_string(hi)};
    }
    return std::nullopt;
  }
  // G2: a tile with a cap in a wall that lies in a collapsed face of the cage.
  std::optional<MicroDefect> collapse_defect(std::uint32_t g, int wall) const {
    const MicroGrid& grid = micro_.grids[g];
    const auto axis = static_cast<std::size_t>(wall / 2);
    const KnotAxis<Rational>& a = micro_.cage[grid.volume].axis(axis);
    const bool is_outer = wall % 2 == 0 ? grid.breaks[axis].front() == a.domain_begin()
                                        : grid.breaks[axis].back() == a.domain_end();
    if (!is_outer || !cage_.face(grid.volume, static_cast<std::size_t>(wall)).is_collapsed())
      return std::nullopt;
    const Grid<3> shape = grid.shape();
    for (std::uint64_t c = 0; c < grid.tiles.size(); ++c) {
      const std::size_t index = c / shape.stride(axis) % shape.size[axis];
      if (grid.tiles[c] == 0 || index != (wall % 2 == 0 ? 0 : shape.size[axis] - 1)) continue;
      if (tiles_[grid.tiles[c] - 1u].caps_of_wall[static_cast<std::size_t>(wall)].empty()) continue;
      const CellWall at{g, c, wall};
      return MicroDefect{
          "G2",
          {at},
          "the tile has a cap in wall " + name_of_wall(micro_, at) + ", which is collapsed"};
    }
    return std::nullopt;
  }
  MicroDefect clash_of(const WallPair& pair, const std::array<std::uint32_t, 2>& caps) const {
    return {"T4",
            {pair.walls[0], pair.walls[1]},
            "cap " + std::to_string(caps[0]) + " in wall " + name_of_wall(micro_, pair.walls[0]) +
                " and cap " + std::to_string(caps[1]) + " in wall " +
                name_of_wall(micro_, pair.walls[1]) + " are neither equal nor apart"};
  }

  template <typename Use>
  void with_match(const WallPair& pair, Use use) {
    const std::array<std::uint32_t, 2> tiles = {tile_of(pair.walls[0]), tile_of(pair.walls[1])};
    if (pair.has_shared_number)
      if (const CapMatch* const all = matcher_.match_for_all(pair, tiles)) return use(*all);
    use(matcher_.match(pair, tiles, {numbers_of(pair.walls[0]), numbers_of(pair.walls[1])}));
  }
  void add_pair(const WallPair& pair, const std::array<std::uint32_t, 2>& caps) {
    ++counts_.glued_caps;
    euler_ -= tiles_[tile_of(pair.walls[0])].caps[caps[0]].euler;
    const std::uint32_t a = number_of_cell(pair.walls[0]), b = number_of_cell(pair.walls[1]);
    glued_[a] |= std::uint64_t{1} << caps[0];
    glued_[b] |= std::uint64_t{1} << caps[1];
    components_.join(a, b);
  }

  void count() {
    bool is_one_shell_each = true;
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g)
      for (std::uint64_t c = 0; c < micro_.grids[g].tiles.size(); ++c) {
        const std::uint32_t tile = micro_.grids[g].tiles[c];
        if (tile == 0) continue;
        const std::uint32_t cell = number_of_cell({g, c, 0});
        euler_ += tiles_[tile - 1].surface.euler() / 2;
        counts_.components += components_.find(cell) == cell;
        is_one_shell_each = is_one_shell_each && shells_of(tile - 1, glued_[cell]).count == 1;
      }
    counts_.shells = is_one_shell_each ? counts_.components : count_shells();
    if (is_one_shell_each && first_patches_ != nullptr) list_components();
    counts_.genus = static_cast<std::int64_t>(counts_.shells) - euler_;
  }
  // The first patches of shells, if each component has one shell.
  void list_components() {
    for_each_tile([&](std::uint32_t g, std::uint64_t c, std::uint32_t root) {
      const std::uint32_t cell = number_of_cell({g, c, 0});
      if (root == cell) add_first_patches({g, c, 0}, [](std::uint32_t) { return true; });
    });
  }
  // The first patches of those shells of a tile for which `is_first` holds.
  template <typename IsFirst>
  void add_first_patches(const CellWall& at, IsFirst is_first) {
    const TileShells& own = shells_of(tile_of(at), glued_[number_of_cell(at)]);
    std::uint32_t next = 0;
    for (std::uint32_t p = 0; p < own.shell_of_patch.size(); ++p) {
      if (own.shell_of_patch[p] != next) continue;
      if (is_first(next)) first_patches_->push_back({at.grid, at.cell, p});
      ++next;
    }
  }
  std::uint64_t count_shells() {
    std::vector<std::uint32_t> first(counts_.cells);
    std::uint32_t next = 0;
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g)
      for (std::uint64_t c = 0; c < micro_.grids[g].tiles.size(); ++c) {
        const std::uint32_t cell = number_of_cell({g, c, 0});
        first[cell] = next;
        if (const std::uint32_t tile = micro_.grids[g].tiles[c]; tile != 0)
          next += shells_of(tile - 1, glued_[cell]).count;
      }
    DisjointSets<> shells(next);
    for_each_wall_pair(micro_, cage_, [&](const WallPair& pair) {
      with_match(pair, [&](const CapMatch& match) {
        for (const auto& caps : match.equal) join_shells(pair, caps, first, shells);
      });
      return true;
    });
    std::uint64_t n = 0;
    for (std::uint32_t s = 0; s < next; ++s) n += shells.find(s) == s;
    if (first_patches_ != nullptr)
      for_each_tile([&](std::uint32_t g, std::uint64_t c, std::uint32_t) {
        const std::uint32_t begin = first[number_of_cell({g, c, 0})];
        add_first_patches({g, c, 0},
                          [&](std::uint32_t s) { return shells.find(begin + s) == begin + s; });
      });
    return n;
  }
  // Joins the shells on both sides of each side of the rim of two equal caps.
  void join_shells(const WallPair& pair, const std::array<std::uint32_t, 2>& caps,
                   const std::vector<std::uint32_t>& first, DisjointSets<>& shells) {
    std::array<std::map<std::string, std::uint32_t>, 2> rims;
    for (std::size_t side = 0; side < 2; ++side) {
      const CellWall& w = pair.walls[side];
      const AnalysedTile& tile = tiles_[tile_of(w)];
      const std::uint32_t cell = number_of_cell(w);
      const TileShells& own = shells_of(tile_of(w), glued_[cell]);
      for (const RimSide& r : rim_of(tile, caps[side], pair, side, numbers_of(w)))
        rims[side][r.key] = first[cell] + own.shell_of_patch[r.outer_patch];
    }
    for (const auto& [key, shell] : rims[0])
      if (const auto other = rims[1].find(key); other != rims[1].end())
        shells.join(shell, other->second);
  }

  const TileShells& shells_of(std::uint32_t tile, std::uint64_t glued) {
    const auto [at, is_new] = shells_.try_emplace({tile, glued});
    if (is_new) at->second = shells_without(tiles_[tile], glued);
    return at->second;
  }

  const Microstructure& micro_;
  const VModel& cage_;
  const std::vector<AnalysedTile>& tiles_;
  CapMatcher matcher_;
  DisjointSets<> components_;
  std::vector<std::uint64_t> first_cell_;  // of each grid
  std::vector<std::uint64_t>
      glued_;  // of each cell, a bit for each cap that is equal to another one
  std::map<std::pair<std::uint32_t, std::uint64_t>, TileShells> shells_;
  MicroCounts counts_;
  std::int64_t euler_ = 0;
  std::optional<MicroDefect> defect_;
  std::vector<CellPatch>* first_patches_ = nullptr;
};

}  // namespace

std::variant<MicroCounts, MicroDefect> topology_of(const Microstructure& micro, const VModel& cage,
                                                   const std::vector<AnalysedTile>& tiles,
                                                   std::vector<CellPatch>* first_patches) {
  return Topology(micro, cage, tiles).run(first_patches);
}

namespace {

// `floating` names the cells to be emptied.
std::variant<std::vector<std::vector<std::uint64_t>>, MicroDefect> empty_cells(
    const VModel& cage, const std::vector<AnalysedTile>& tiles,
    std::vector<std::vector<std::uint64_t>> (Topology::*floating)(), Microstructure& micro) {
  Topology topology(micro, cage, tiles);
  auto counts = topology.run();
  if (auto* defect = std::get_if<MicroDefect>(&counts)) return std::move(*defect);
  std::vector<std::vector<std::uint64_t>> out = (topology.*floating)();
  for (std::size_t g = 0; g < out.size(); ++g)
    for (const std::uint64_t c : out[g]) micro.grids[g].tiles[c] = 0;
  return out;
}

}  // namespace

std::variant<std::vector<std::vector<std::uint64_t>>, MicroDefect> keep_largest_component(
    const VModel& cage, const std::vector<AnalysedTile>& tiles, Microstructure& micro) {
  return empty_cells(cage, tiles, &Topology::floating, micro);
}

std::variant<std::vector<std::vector<std::uint64_t>>, MicroDefect> keep_bridged_components(
    const VModel& cage, const std::vector<AnalysedTile>& tiles, Microstructure& micro) {
  return empty_cells(cage, tiles, &Topology::without_bridges, micro);
}

}  // namespace veritope
