// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/micro_nest.h: the option --nest of veritope micro: tiles in the volumes of tiles.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/tile_option.h"
#include "robust/base/result.h"
#include "solids/micro/microstructure.h"

namespace veritope::cli {

/// The inner tile, and the numbers of its cells along the axes of each volume of an outer tile.
struct NestChoice {
  TileChoice tile;
  std::array<std::uint64_t, 3> counts{};
};

/// "jack,degree=1:3,3,3". Returns nothing, or what is wrong with the text, in words that follow the name of the option.
std::string take_nest(const std::string& text, std::optional<NestChoice>& nest);

/// Why these options exclude --nest, as a sentence; empty if they do not.
std::string fault_of_nest(const std::vector<TileChoice>& tiles, bool is_doubled,
                          bool asks_for_bridges);

/// The volumes of the tiles that the cells hold, as a cage.
/// @param range  of the numbers of walls with which the tiles were made
/// @error as composed_cage
/// REQUIRES that each tile of outer is one of the tiles, all jacks, with some arms.
Result<std::vector<VVolume>> nested_cage(const Microstructure& outer,
                                         const std::vector<TileChoice>& tiles,
                                         const std::optional<std::array<std::int32_t, 2>>& range);

}  // namespace veritope::cli
