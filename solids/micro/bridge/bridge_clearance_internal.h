// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/bridge_clearance_internal.h: does a bridge or a sweep, in space, miss the surface of the solid, and is its
// end near it? The conditions I1 and I4 of docs/certificates/micro-inside.md, for one bridge. Internal to
// solids/micro/bridge.
#pragma once
#include <optional>

#include "solids/micro/bridge/cage_space_internal.h"
#include "solids/micro/surface/solid_surface.h"
#include "solids/micro/sweep_nodes.h"

namespace veritope {

/// True only if the bridge, mapped to space, has no point in common with the surface.
/// REQUIRES a bridge in the parameters of the volume.
bool misses_surface(SurfaceView& surface, const internal::VolumeSpace& volume,
                    const MicroBridge& bridge);
bool misses_surface(SurfaceView& surface, SweepNodes& sweep);

/// A bound of the distance from every point of the end face to the surface, at most `most`; nothing if none is proved.
std::optional<double> end_distance(SurfaceView& surface, const internal::VolumeSpace& volume,
                                   const MicroBridge& bridge, double most);
std::optional<double> end_distance(SurfaceView& surface, SweepNodes& sweep, double most);

}  // namespace veritope
