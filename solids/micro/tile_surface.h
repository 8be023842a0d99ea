// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/tile_surface.h: how the patches of a tile are glued along equal sides. The condition S0 of
// docs/certificates/microstructure.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solids/micro/tile_family.h"

namespace veritope {

/// Why no certificate can speak of a tile.
struct TileDefect {
  const char* condition = "";  ///< "S0", "F1", "F2", "F3", "T2" or "T3" of the certificate's page
  std::optional<std::uint32_t> patch;
  std::optional<int> wall;  ///< 2 axis + end
  std::string message;
};

/// A closed surface of patches. Side s of patch p has the number 4 p + s.
struct TileSurface {
  static constexpr std::uint32_t kCollapsed = 0xffffffff;

  std::vector<std::uint32_t> mates;  ///< of each side: the side that it is glued to, or kCollapsed
  std::vector<std::uint32_t> vertices;  ///< of each corner 4 p + c: its vertex; numbers from 0
  std::size_t num_vertices = 0, num_edges = 0;

  std::size_t num_patches() const { return mates.size() / kTileSides; }
  bool is_collapsed(std::size_t patch, std::size_t side) const {
    return mates[kTileSides * patch + side] == kCollapsed;
  }
  std::uint32_t vertex(std::size_t patch, std::size_t corner) const {
    return vertices[kTileSides * patch + corner % kTileSides];
  }
  std::int64_t euler() const {
    return static_cast<std::int64_t>(num_vertices) - static_cast<std::int64_t>(num_edges) +
           static_cast<std::int64_t>(num_patches());
  }
};

/// REQUIRES a tile as docs/formats/micro-files.md has it.
std::variant<TileSurface, TileDefect> surface_of(const MicroTile& tile);

}  // namespace veritope
