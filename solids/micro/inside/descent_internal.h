// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/descent_internal.h: nodes of docs/certificates/micro-inside.md, section 3. Internal to
// solids/micro/inside.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "solids/micro/inside/inside_parts_internal.h"
#include "solids/micro/surface/close_descent.h"

namespace veritope::internal {

/// A part of a polynomial map of [0,1]^N, enclosed: Bernstein coefficients, the last axis fastest. All functions
/// REQUIRE a live ScopedUpward.
template <std::size_t N>
struct MapNode {
  std::array<int, N> degrees{};
  std::vector<Box3> points;
  int level = 0;

  Box3 box() const {
    Box3 out = points.front();
    for (const Box3& p : points)
      for (std::size_t c = 0; c < 3; ++c) out[c] = hull(out[c], p[c]);
    return out;
  }
  /// Cut at 1/2 along the axis level mod N.
  std::pair<MapNode, MapNode> halves() const;
};
using PatchNode = MapNode<2>;
using BridgeNode = MapNode<3>;

BridgeNode enclosed_bridge(const MicroBridge& bridge);

/// The ends of the sides of a box.
Box3 lower_ends(const Box3& x);
Box3 upper_ends(const Box3& x);

/// The points of nodes of one volume, in all of its knot spans that they meet.
class BridgeMaps {
 public:
  explicit BridgeMaps(const VolumeMaps& maps) : maps_(maps) {}
  /// @param x  parameters of the volume
  /// Returns false if a weight may be 0 or less. REQUIRES a live ScopedUpward.
  bool points(const Box3& x, std::vector<NodePoints>* out) const;
  /// The points, for each span.
  bool boxes(const Box3& x, std::vector<std::vector<Box3>>* out) const;
  double checkers_error() const { return maps_.checkers_error(); }

 private:
  const VolumeMaps& maps_;
};

}  // namespace veritope::internal
