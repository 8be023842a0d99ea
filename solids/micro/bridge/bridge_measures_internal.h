// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/bridge_measures_internal.h: angles and distances that are reported of bridges. Internal to
// solids/micro/bridge.
#pragma once
#include "interval/box.h"
#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/bridge/cage_space_internal.h"
#include "solids/micro/bridge/skin_projection_internal.h"

namespace veritope::internal {

inline constexpr BridgeRange kAnyAngle = {0, 180};

/// `range` becomes the hull of both, or `more` if it is the first one.
void widen(const BridgeRange& more, bool is_first, BridgeRange* range);

/// All REQUIRE a live ScopedUpward.
Box3 hull_of(const HullPoints& points);
/// Contains the angles, in degrees, between the vectors of both boxes.
BridgeRange angle_between(const Box3& a, const Box3& b);
/// No point of the box is nearer to the surface.
double distance_below(const SkinProjection& projection, const Box3& at);

}  // namespace veritope::internal
