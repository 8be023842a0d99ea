// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/enclosed_patch_internal.h: patches of tiles in interval Bezier form. Internal to
// solids/micro/inside.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "interval/box.h"
#include "solids/micro/micro_tile.h"

namespace veritope::internal {

/// A patch of a kind of tile, enclosed: a net for each power of t.
struct EnclosedPatch {
  std::array<int, 2> degrees{};
  std::optional<int> wall;
  std::vector<std::vector<Box3>> powers;
};
std::vector<EnclosedPatch> enclosed_patches(const MicroTile& tile);

/// Its coefficients for the number of the wall. REQUIRES a live ScopedUpward.
void patch_points(const EnclosedPatch& patch, std::int32_t number, std::vector<Box3>* out);

}  // namespace veritope::internal
