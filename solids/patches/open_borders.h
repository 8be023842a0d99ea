// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/open_borders.h: how open a complex is: its open sides, the borders that they form, and how near other
// open sides lie to them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// One side that occurs once.
struct OpenSide {
  PatchSide side;
  std::array<Point3d, 2> ends;    ///< in the side's direction of travel, rounded
  double length = 0;              ///< the distance of its ends, approximately
  std::optional<PatchSide> near;  ///< the near side (see OpenBorders) that differs least from it
  double distance = 0;            ///< how much that one differs
};

struct OpenBorders {
  std::uint64_t sides = 0;
  std::uint64_t borders = 0;  ///< classes of open sides by common vertices of the surface
  /// Open sides that differ from another one (kNearMiss), as far as the complex lists them, by at most a sixteenth of
  /// the distance of its ends; and the least and the greatest of these differences: each is the greatest one of two
  /// coordinates of control points, rounded to nearest. Differences that round to 0 do not count.
  std::uint64_t near_sides = 0;
  double least = 0, greatest = 0;
  /// The number of shells, if all are open and nothing else is wrong with the complex: each is a sheet with borders.
  std::uint64_t sheets = 0;
  std::vector<OpenSide> longest;  ///< longest first
};

/// @param max_listed  the most sides that are listed in `longest`
/// @cost  O(n log n) for n open sides, and linear in the number of all
OpenBorders open_borders(const PatchComplex& complex, std::size_t max_listed = 0);

}  // namespace veritope
