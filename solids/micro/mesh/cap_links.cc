// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "robust/base/parallel.h"
#include "solids/micro/mesh/cap_links_internal.h"

namespace veritope::internal {
namespace {

class LinkFinder {
 public:
  LinkFinder(const Microstructure& micro, const VModel& cage,
             const std::vector<AnalysedTile>& tiles)
      : micro_(micro), cage_(cage), tiles_(tiles), matcher_(tiles) {}

  Result<CapLinks> run() {
    number_cells();
    const bool is_complete = for_each_wall_pair(micro_, cage_, [&](const WallPair& pair) {
      link(pair);
      return !error_.has_value();
    });
    if (error_.has_value()) return std::move(*error_);
    if (!is_complete)
      return Error{
          Code::kOverLimit,
          {},
          "more than " + std::to_string(kMaxWallMeetings) + " pairs of walls meet between grids"};
    sort_links();
    return std::move(out_);
  }

 private:
  // The most blocks of all grids, but for the few that every grid may have.
  static constexpr std::size_t kBlocks = 4096, kFewBlocks = 27;
  // Rims that two cells of two kinds share, in the order of the equal caps.
  using Rims = std::vector<std::uint32_t>;

  // Blocks are cubes of 1, 2, 4, ... cells along an axis, so large that there are not too many.
  std::size_t block_length(const Grid<3>& shape) const {
    const std::size_t most = std::max(kFewBlocks, kBlocks / micro_.grids.size());
    for (std::size_t length = 1;; length *= 2) {
      Grid<3> blocks;
      for (std::size_t a = 0; a < 3; ++a) blocks.size[a] = num_chunks(shape.size[a], length);
      if (blocks.count() <= most) return length;
    }
  }
  void number_cells() {
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g) {
      const MicroGrid& grid = micro_.grids[g];
      const Grid<3> shape = grid.shape();
      const std::size_t length = block_length(shape);
      std::map<std::tuple<std::array<std::size_t, 3>, std::uint32_t>, std::uint32_t> kinds;
      auto& numbers = out_.numbers.emplace_back(grid.tiles.size(), CapLinks::kNoCell);
      for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
        if (grid.tiles[c] == 0) continue;
        MeshKind kind{g, grid.tiles[c] - 1u, {}};
        std::array<std::size_t, 3> at = shape.index_of(c);
        for (std::size_t a = 0; a < 3; ++a) {
          at[a] -= at[a] % length;
          kind.block[a] = {at[a], std::min(at[a] + length, shape.size[a])};
        }
        const auto [known, is_new] =
            kinds.try_emplace({at, kind.tile}, static_cast<std::uint32_t>(out_.kinds.size()));
        if (is_new) out_.kinds.push_back(kind);
        numbers[c] = static_cast<std::uint32_t>(out_.cells.size());
        out_.cells.emplace_back().kind = known->second;
      }
    }
    out_.strictness.assign(out_.kinds.size(), 0);
  }
  std::uint32_t number_of(const CellWall& w) const { return out_.numbers[w.grid][w.cell]; }
  WallNumbers wall_numbers(const CellWall& w) const {
    const MicroGrid& g = micro_.grids[w.grid];
    return g.numbers_of(g.shape().index_of(w.cell));
  }

  void link(const WallPair& pair) {
    const std::array<std::uint32_t, 2> cells = {number_of(pair.walls[0]), number_of(pair.walls[1])};
    const std::array<std::uint32_t, 2> kinds = {out_.cells[cells[0]].kind,
                                                out_.cells[cells[1]].kind};
    const std::array<std::uint32_t, 2> tiles = {out_.kinds[kinds[0]].tile,
                                                out_.kinds[kinds[1]].tile};
    const std::size_t owner = cells[1] < cells[0] ? 1 : 0;
    if (pair.has_shared_number)
      if (const CapMatch* const all = matcher_.match_for_all(pair, tiles)) {
        // The equal sides of rims that are equal for all numbers are the same ones for each number.
        const auto [at, is_new] =
            rims_for_all_.try_emplace({kinds[0], kinds[1], pair.walls[0].wall});
        if (is_new) at->second = rims_of(pair, *all, kinds, owner);
        return add(cells, owner, at->second);
      }
    const CapMatch match =
        matcher_.match(pair, tiles, {wall_numbers(pair.walls[0]), wall_numbers(pair.walls[1])});
    if (match.clash.has_value()) {
      error_ = bad_argument("a cap in wall " + name_of_wall(micro_, pair.walls[0]) +
                            " and one in wall " + name_of_wall(micro_, pair.walls[1]) +
                            " are neither equal nor apart");
      return;
    }
    add(cells, owner, rims_of(pair, match, kinds, owner));
  }

  Rims rims_of(const WallPair& pair, const CapMatch& match,
               const std::array<std::uint32_t, 2>& kinds, std::size_t owner) {
    Rims out;
    for (const auto& caps : match.equal) {
      std::array<std::map<std::string, RimSide>, 2> sides;
      for (std::size_t side = 0; side < 2; ++side)
        for (const RimSide& r : rim_of(tiles_[out_.kinds[kinds[side]].tile], caps[side], pair, side,
                                       wall_numbers(pair.walls[side])))
          sides[side][r.key] = r;
      SharedRim rim{kinds[owner], kinds[1 - owner], caps[owner], caps[1 - owner], {}};
      for (const auto& [key, mine] : sides[owner]) {
        const auto other = sides[1 - owner].find(key);
        if (other == sides[1 - owner].end()) continue;
        rim.sides.push_back(
            {mine.side, other->second.side, mine.is_backwards != other->second.is_backwards});
      }
      if (rim.sides.size() != sides[0].size() || rim.sides.size() != sides[1].size())
        error_ = bad_argument("equal caps of " + name_of_wall(micro_, pair.walls[0]) + " and " +
                              name_of_wall(micro_, pair.walls[1]) + " have different rims");
      std::sort(rim.sides.begin(), rim.sides.end());
      const auto [at, is_new] =
          known_.try_emplace(std::move(rim), static_cast<std::uint32_t>(out_.rims.size()));
      if (is_new) out_.rims.push_back(at->first);
      out.push_back(at->second);
    }
    return out;
  }

  void add(const std::array<std::uint32_t, 2>& cells, std::size_t owner, const Rims& rims) {
    for (const std::uint32_t r : rims) {
      const SharedRim& rim = out_.rims[r];
      LinkedCell &mine = out_.cells[cells[owner]], &other = out_.cells[cells[1 - owner]];
      const std::uint64_t my_bit = std::uint64_t{1} << rim.owner_cap,
                          other_bit = std::uint64_t{1} << rim.user_cap;
      if ((mine.dropped & my_bit) != 0 || (other.dropped & other_bit) != 0) {
        error_ = bad_argument("a cap is equal to two others");
        return;
      }
      mine.dropped |= my_bit;
      other.dropped |= other_bit;
      other.borrowed |= other_bit;
      out_.links.push_back({cells[1 - owner], cells[owner], r});
    }
  }

  void sort_links() {
    auto& links = out_.links;
    std::sort(links.begin(), links.end(), [&](const RimLink& a, const RimLink& b) {
      return std::tuple(a.user, out_.rims[a.rim].user_cap) <
             std::tuple(b.user, out_.rims[b.rim].user_cap);
    });
    std::uint32_t at = 0;
    for (std::uint32_t c = 0; c < out_.cells.size(); ++c) {
      out_.cells[c].first_link = at;
      for (; at < links.size() && links[at].user == c; ++at) {
        const std::uint32_t owner = links[at].owner;
        int need = owner == c ? 2 : 0;
        for (std::uint32_t k = out_.cells[c].first_link; k < at; ++k)
          if (links[k].owner == owner) need = std::max(need, 1);
        for (const std::uint32_t kind : {out_.cells[c].kind, out_.cells[owner].kind})
          out_.strictness[kind] = std::max(out_.strictness[kind], need);
      }
    }
  }

  const Microstructure& micro_;
  const VModel& cage_;
  const std::vector<AnalysedTile>& tiles_;
  CapMatcher matcher_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, int>, Rims> rims_for_all_;
  std::map<SharedRim, std::uint32_t> known_;
  std::optional<Error> error_;
  CapLinks out_;
};

}  // namespace

Result<CapLinks> links_of(const Microstructure& micro, const VModel& cage,
                          const std::vector<AnalysedTile>& tiles) {
  return LinkFinder(micro, cage, tiles).run();
}

}  // namespace veritope::internal
