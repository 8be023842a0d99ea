// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/tile_surface.h"

#include <unordered_map>
#include <utility>

#include "robust/base/disjoint_sets.h"

namespace veritope {
namespace {

TileDefect open_side(std::uint32_t side, const char* what) {
  return {"S0", side / kTileSides, std::nullopt,
          "side " + std::to_string(side % kTileSides) + " of patch " +
              std::to_string(side / kTileSides) + " " + what};
}

}  // namespace

std::variant<TileSurface, TileDefect> surface_of(const MicroTile& tile) {
  TileSurface out;
  const std::size_t n = tile.patches.size();
  out.mates.assign(kTileSides * n, TileSurface::kCollapsed);
  std::unordered_map<std::string, std::uint32_t> forward;
  for (std::uint32_t side = 0; side < out.mates.size(); ++side) {
    std::string key = side_key(tile.patches[side / kTileSides], side % kTileSides, false);
    if (key.empty()) continue;
    if (!forward.try_emplace(std::move(key), side).second)
      return open_side(side, "is equal to another one, not opposite to it");
  }
  DisjointSets<> corners(kTileSides * n);
  for (std::uint32_t side = 0; side < out.mates.size(); ++side) {
    const std::uint32_t patch = side / kTileSides, s = side % kTileSides;
    const std::uint32_t first = side, last = kTileSides * patch + (s + 1) % kTileSides;
    const std::string key = side_key(tile.patches[patch], s, true);
    if (key.empty()) {
      corners.join(first, last);
      continue;
    }
    const auto opposite = forward.find(key);
    if (opposite == forward.end()) return open_side(side, "is glued to no other one");
    if (opposite->second == side) return open_side(side, "is its own opposite");
    out.mates[side] = opposite->second;
    const std::uint32_t other = opposite->second / kTileSides * kTileSides;
    corners.join(first, other + (opposite->second + 1) % kTileSides);
    corners.join(last, opposite->second);
    out.num_edges += side < opposite->second;
  }
  out.vertices.resize(corners.size());
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    const std::uint32_t least = corners.find(c);
    out.vertices[c] =
        least == c ? static_cast<std::uint32_t>(out.num_vertices++) : out.vertices[least];
  }
  return out;
}

}  // namespace veritope
