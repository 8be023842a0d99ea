// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge_faces.h"

#include "splines/bezier_domain.h"

namespace veritope {

BezierVolume<Rational> bridge_map(const MicroBridge& bridge) {
  BezierVolume<Rational> out({bridge.degrees[0], bridge.degrees[1], kBridgeAxisDegree}, 3, false);
  for (std::size_t i = 0; i < bridge.points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.component(static_cast<int>(c))[i] = bridge.points[i][c];
  return out;
}

// boundary() keeps the order of the other axes: (v, w) turns towards u, (u, w) away from v, (u, v) towards w.
std::array<BezierSurface<Rational>, kFreeBridgeFaces> free_faces(const MicroBridge& bridge) {
  const BezierVolume<Rational> map = bridge_map(bridge);
  return {swapped(boundary(map, 0, 0), 0, 1), boundary(map, 0, 1), boundary(map, 1, 0),
          swapped(boundary(map, 1, 1), 0, 1), boundary(map, 2, 1)};
}

BezierSurface<Rational> covering_face(const MicroBridge& bridge) {
  return swapped(boundary(bridge_map(bridge), 2, 0), 0, 1);
}

}  // namespace veritope
