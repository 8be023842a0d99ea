// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cap_matching.h: which caps of two walls that meet are equal. The condition T4 of
// docs/certificates/microstructure.md.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "solids/micro/tile_analysis.h"
#include "solids/micro/wall_pairs.h"

namespace veritope {

/// Caps of two walls, by their numbers in the two tiles.
struct CapMatch {
  std::vector<std::array<std::uint32_t, 2>> equal;
  /// Two caps that are neither equal nor proved apart; the match does not hold.
  std::optional<std::array<std::uint32_t, 2>> clash;
};

/// A side of a cap that is glued to a patch outside of it.
struct RimSide {
  std::string key;  ///< equal for the equal sides of equal caps
  std::uint32_t outer_patch = 0;
  std::uint32_t side = 0;     ///< 4 patch + side of the cap's patch
  bool is_backwards = false;  ///< equal sides run in one direction iff this is equal, too
};
/// The rim of a cap in wall number `side` of the pair.
std::vector<RimSide> rim_of(const AnalysedTile& tile, std::uint32_t cap, const WallPair& pair,
                            std::size_t side, const WallNumbers& numbers);

/// Compares caps, and remembers the answers for walls with one number. The tiles must outlive it.
class CapMatcher {
 public:
  explicit CapMatcher(const std::vector<AnalysedTile>& tiles);

  /// The caps of two walls of tiles. `numbers`: those of the two cells.
  CapMatch match(const WallPair& pair, const std::array<std::uint32_t, 2>& tiles,
                 const std::array<WallNumbers, 2>& numbers);
  /// The answer for all numbers, if the caps depend on none but the number of their wall, which both walls of the
  /// pair share; null if it depends on the numbers. REQUIRES pair.has_shared_number.
  const CapMatch* match_for_all(const WallPair& pair, const std::array<std::uint32_t, 2>& tiles);

 private:
  const std::vector<AnalysedTile>& tiles_;
  /// By tiles and axis; nothing where it depends on the numbers.
  std::map<std::tuple<std::uint32_t, std::uint32_t, int>, std::optional<CapMatch>> for_all_;
};

}  // namespace veritope
