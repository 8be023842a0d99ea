// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/convex_polygon.h: triangles of convex polygons in which angles of 180 degrees occur.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/implicit_kinds.h"

namespace veritope {

/// Triangles of a convex polygon, each as three places in `corners`, none of them flat, in the polygon's direction.
/// Where a corner allows it they all contain one corner: that with the least rank. REQUIRES corners that are not all on
/// a line; ranks are different.
std::vector<std::array<std::uint32_t, 3>> triangulate_convex(std::span<const AnyPoint3> corners,
                                                             std::span<const std::uint32_t> ranks);

}  // namespace veritope
