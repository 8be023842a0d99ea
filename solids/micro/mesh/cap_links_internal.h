// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/cap_links_internal.h: the cells that hold tiles, and which of them share the rims of equal caps.
// Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/cap_matching.h"

namespace veritope::internal {

/// The cells of a block of a grid that hold one tile: they are cut in one way.
struct MeshKind {
  std::uint32_t grid = 0, tile = 0;
  std::array<std::array<std::size_t, 2>, 3>
      block{};  ///< along each axis: the first cell, and one past the last
};
/// Equal sides of two rims, 4 patch + side.
struct SharedSide {
  std::uint32_t owner = 0, user = 0;
  bool is_reversed = false;  ///< they run in opposite directions
  friend auto operator<=>(const SharedSide&, const SharedSide&) = default;
};
/// How a cell of one kind uses the vertices of another cell's rim.
struct SharedRim {
  std::uint32_t owner_kind = 0, user_kind = 0, owner_cap = 0, user_cap = 0;
  std::vector<SharedSide> sides;
  friend auto operator<=>(const SharedRim&, const SharedRim&) = default;
};
struct RimLink {
  std::uint32_t user = 0, owner = 0;  ///< numbers of cells with tiles; owner <= user
  std::uint32_t rim = 0;              ///< into CapLinks::rims
};

struct LinkedCell {
  std::uint64_t dropped = 0;   ///< a bit for each cap that is equal to another one
  std::uint64_t borrowed = 0;  ///< those whose rims' vertices are the other cell's
  std::uint32_t kind = 0;
  std::uint32_t first_link = 0;  ///< those of its borrowed rims, by caps
};

struct CapLinks {
  static constexpr std::uint32_t kNoCell = 0xffffffff;

  std::vector<MeshKind> kinds;
  std::vector<LinkedCell> cells;  ///< by grids and cells
  std::vector<SharedRim> rims;
  std::vector<RimLink> links;  ///< by users
  std::vector<std::vector<std::uint32_t>>
      numbers;  ///< of each cell of each grid: into cells, or kNoCell
  /// By kinds: 1 if a cell shares two caps with another one, 2 if it shares caps with itself.
  std::vector<int> strictness;
};

/// @error kBadArgument: caps that are neither equal nor apart, or a cap that is equal to two; kOverLimit: more than
///        kMaxWallMeetings pairs of walls between grids
Result<CapLinks> links_of(const Microstructure& micro, const VModel& cage,
                          const std::vector<AnalysedTile>& tiles);

}  // namespace veritope::internal
