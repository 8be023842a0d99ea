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

// In homogeneous coordinates the curve's points count times the weight.
BezierVolume<Rational> sweep_map(const MicroSweep& sweep, const BezierSurface<Rational>& image) {
  BezierVolume<Rational> out({image.degree(0), image.degree(1), kBridgeAxisDegree},
                             image.num_components(), image.is_rational());
  const std::array<TilePoint, 3> curve = {TilePoint(), sweep.axis[0], sweep.axis[1]};
  for (std::size_t i = 0; i < image.grid().count(); ++i)
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const std::size_t at = i * curve.size() + k;
      for (std::size_t c = 0; c < 3; ++c) {
        Rational g = curve[k][c];
        if (image.is_rational()) g *= image.component(3)[i];
        out.component(static_cast<int>(c))[at] = image.component(static_cast<int>(c))[i] + g;
      }
      if (image.is_rational()) out.component(3)[at] = image.component(3)[i];
    }
  return out;
}

std::array<BezierSurface<Rational>, kFreeBridgeFaces> free_faces(const MicroBridge& bridge) {
  return free_faces(bridge_map(bridge));
}
// boundary() keeps the order of the other axes: (v, w) turns towards u, (u, w) away from v, (u, v) towards w.
std::array<BezierSurface<Rational>, kFreeBridgeFaces> free_faces(
    const BezierVolume<Rational>& map) {
  return {swapped(boundary(map, 0, 0), 0, 1), boundary(map, 0, 1), boundary(map, 1, 0),
          swapped(boundary(map, 1, 1), 0, 1), boundary(map, 2, 1)};
}

BezierSurface<Rational> covering_face(const MicroBridge& bridge) {
  return swapped(boundary(bridge_map(bridge), 2, 0), 0, 1);
}

}  // namespace veritope
