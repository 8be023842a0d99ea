// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge_faces.h: a bridge as a map, and the faces of its boundary, in the parameters of its volume; a
// sweep as a map into space.
#pragma once
#include <array>
#include <cstddef>

#include "solids/micro/micro_bridge.h"
#include "splines/bezier.h"

namespace veritope {

/// The map b of [0,1]^3. REQUIRES the net of a bridge.
BezierVolume<Rational> bridge_map(const MicroBridge& bridge);
/// A sweep as a map of [0,1]^3 into space. REQUIRES the image of its cap.
BezierVolume<Rational> sweep_map(const MicroSweep& sweep, const BezierSurface<Rational>& image);

inline constexpr std::size_t kFreeBridgeFaces = 4 + 1;
/// The faces u = 0, u = 1, v = 0, v = 1 and w = 1 of the bridge: all but its cap. S_u x S_v turns outward, since a
/// bridge is right-handed in the parameters.
std::array<BezierSurface<Rational>, kFreeBridgeFaces> free_faces(const MicroBridge& bridge);
std::array<BezierSurface<Rational>, kFreeBridgeFaces> free_faces(const BezierVolume<Rational>& map);
/// The face w = 0, which covers the cap, turned outward like the others.
BezierSurface<Rational> covering_face(const MicroBridge& bridge);

}  // namespace veritope
