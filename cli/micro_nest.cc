// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/micro_nest.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "robust/base/check.h"
#include "solids/micro/compose/composed_cage.h"
#include "solids/micro/jack_volumes.h"

namespace veritope::cli {
namespace {

constexpr unsigned kArmSets = 64;

// The jack of which this is the tile; its range may be a part of the one with which it was made.
JackShape shape_of_tile(const MicroTile& tile, const std::vector<TileChoice>& tiles,
                        const std::optional<std::array<std::int32_t, 2>>& range) {
  for (const TileChoice& choice : tiles)
    for (unsigned arms = kArmSets; arms-- > 0;) {
      JackShape shape = std::get<JackShape>(choice);
      shape.arms &= arms;
      shape.range = range;
      const Result<MicroTile> made = jack_tile(shape);
      if (made && made->name == tile.name && made->patches == tile.patches) return shape;
    }
  VT_CHECK(false, "a tile is none of the jacks of which it was made");
  return {};
}

}  // namespace

std::string take_nest(const std::string& text, std::optional<NestChoice>& nest) {
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos) return "needs TILE:K,M,N, such as jack:3,3,3, not " + text;
  std::vector<TileChoice> tiles;
  if (std::string why = take_tile(text.substr(0, colon), tiles); !why.empty()) return why;
  if (is_open_choice(tiles.front()))
    return std::string("needs a closed tile, and ") + open_choice_name(tiles.front()) + " is open";
  std::optional<std::array<std::uint64_t, 3>> counts;
  if (std::string why = take_counts(text.substr(colon + 1), counts); !why.empty()) return why;
  nest = NestChoice{std::move(tiles.front()), *counts};
  return "";
}

std::string fault_of_nest(const std::vector<TileChoice>& tiles, bool is_doubled,
                          bool asks_for_bridges) {
  const bool are_jacks = std::all_of(tiles.begin(), tiles.end(), [](const TileChoice& t) {
    return std::holds_alternative<JackShape>(t);
  });
  if (!are_jacks) return "--nest needs outer tiles that are made of volumes: jacks and branches";
  if (is_doubled) return "--nest and --double exclude each other";
  if (asks_for_bridges)
    return "--nest builds no bridges: it excludes --bridge domain and space, --alpha and --skin";
  return "";
}

Result<std::vector<VVolume>> nested_cage(const Microstructure& outer,
                                         const std::vector<TileChoice>& tiles,
                                         const std::optional<std::array<std::int32_t, 2>>& range) {
  std::vector<JackShape> shapes;
  for (const MicroTile& tile : outer.tiles) shapes.push_back(shape_of_tile(tile, tiles, range));
  return composed_cage(outer, [&shapes](std::size_t tile, const WallNumbers& numbers) {
    return jack_volumes(shapes[tile], numbers);
  });
}

}  // namespace veritope::cli
