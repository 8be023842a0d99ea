// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "robust/base/parallel.h"
#include "solids/micro/mesh/cap_links_internal.h"

namespace veritope::internal {
namespace {

// Three numbers as the key of a table.
struct NumberKey {
  std::uint64_t a = 0, b = 0, c = 0;
  friend bool operator==(const NumberKey&, const NumberKey&) = default;
};
struct NumberKeyHash {
  std::size_t operator()(const NumberKey& k) const {
    constexpr std::uint64_t kMix = 0x9e3779b97f4a7c15u;
    std::uint64_t h = k.a * kMix;
    h = (h ^ h >> 29 ^ k.b) * kMix;
    h = (h ^ h >> 29 ^ k.c) * kMix;
    return h ^ h >> 32;
  }
};
// The last key is asked again and again.
template <typename Value>
class NumberTable {
 public:
  /// The value of the key, and whether it is new.
  std::pair<Value&, bool> operator()(const NumberKey& key) {
    if (last_ != nullptr && key == key_) return {*last_, false};
    const auto [at, is_new] = values_.try_emplace(key);
    key_ = key;
    last_ = &at->second;
    return {*last_, is_new};
  }

 private:
  std::unordered_map<NumberKey, Value, NumberKeyHash> values_;
  NumberKey key_;
  Value* last_ = nullptr;
};

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
      Grid<3> blocks;
      for (std::size_t a = 0; a < 3; ++a) blocks.size[a] = num_chunks(shape.size[a], length);
      NumberTable<std::uint32_t> kinds;
      auto& numbers = out_.numbers.emplace_back(grid.tiles.size(), CapLinks::kNoCell);
      for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
        if (grid.tiles[c] == 0) continue;
        const std::uint32_t tile = grid.tiles[c] - 1u;
        std::array<std::size_t, 3> at = shape.index_of(c);
        for (std::size_t& i : at) i /= length;
        const auto [kind, is_new] = kinds({blocks.at(at), tile, 0});
        if (is_new) {
          kind = static_cast<std::uint32_t>(out_.kinds.size());
          MeshKind& made = out_.kinds.emplace_back(MeshKind{g, tile, {}});
          for (std::size_t a = 0; a < 3; ++a)
            made.block[a] = {at[a] * length, std::min((at[a] + 1) * length, shape.size[a])};
        }
        numbers[c] = static_cast<std::uint32_t>(out_.cells.size());
        out_.cells.emplace_back().kind = kind;
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
    if (pair.has_shared_number) {
      const auto wall = static_cast<std::uint64_t>(pair.walls[0].wall);
      const auto [all, is_new] = shared_for_all_({tiles[0], tiles[1], wall});
      if (is_new)
        if (const CapMatch* const match = matcher_.match_for_all(pair, tiles))
          all = rims_of(pair, *match, kinds, owner);
      // The equal sides of rims that are equal for all numbers are the same ones for each number.
      if (all.has_value()) return add(cells, owner, rims_for_all(*all, kinds, owner, wall));
    }
    const CapMatch match =
        matcher_.match(pair, tiles, {wall_numbers(pair.walls[0]), wall_numbers(pair.walls[1])});
    if (match.clash.has_value()) {
      error_ = bad_argument("a cap in wall " + name_of_wall(micro_, pair.walls[0]) +
                            " and one in wall " + name_of_wall(micro_, pair.walls[1]) +
                            " are neither equal nor apart");
      return;
    }
    Rims rims;
    for (SharedRim& rim : rims_of(pair, match, kinds, owner)) {
      const auto [at, is_new] =
          known_.try_emplace(std::move(rim), static_cast<std::uint32_t>(out_.rims.size()));
      if (is_new) out_.rims.push_back(at->first);
      rims.push_back(at->second);
    }
    add(cells, owner, rims);
  }
  // The rims are those of the first pair of cells with these tiles, for other kinds: pairs in a grid come with the
  // lower cell first, which is the owner.
  const Rims& rims_for_all(const std::vector<SharedRim>& all,
                           const std::array<std::uint32_t, 2>& kinds, std::size_t owner,
                           std::uint64_t wall) {
    const auto [rims, is_new] = rims_for_all_({kinds[0], kinds[1], wall});
    if (!is_new) return rims;
    for (SharedRim rim : all) {
      rim.owner_kind = kinds[owner];
      rim.user_kind = kinds[1 - owner];
      rims.push_back(static_cast<std::uint32_t>(out_.rims.size()));
      out_.rims.push_back(std::move(rim));
    }
    return rims;
  }

  std::vector<SharedRim> rims_of(const WallPair& pair, const CapMatch& match,
                                 const std::array<std::uint32_t, 2>& kinds, std::size_t owner) {
    std::vector<SharedRim> out;
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
      out.push_back(std::move(rim));
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

  // By users, then by their caps: first into a list for each user, each of which is short.
  void sort_links() {
    std::vector<std::uint32_t> end(out_.cells.size() + 1, 0);
    for (const RimLink& l : out_.links) ++end[l.user];
    std::uint32_t sum = 0;
    for (std::uint32_t& n : end) sum += std::exchange(n, sum);
    std::vector<RimLink> links(out_.links.size());
    for (const RimLink& l : out_.links) links[end[l.user]++] = l;
    std::size_t begin = 0;
    for (std::size_t c = 0; c < out_.cells.size(); ++c) {
      std::sort(links.begin() + static_cast<std::ptrdiff_t>(begin), links.begin() + end[c],
                [&](const RimLink& a, const RimLink& b) {
                  return out_.rims[a.rim].user_cap < out_.rims[b.rim].user_cap;
                });
      begin = end[c];
    }
    out_.links = std::move(links);
    find_strictness();
  }
  void find_strictness() {
    const auto& links = out_.links;
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
  // By tiles and walls: the rims that are equal for all numbers, of some kinds; nothing if there are none.
  NumberTable<std::optional<std::vector<SharedRim>>> shared_for_all_;
  NumberTable<Rims> rims_for_all_;  // by kinds and walls
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
