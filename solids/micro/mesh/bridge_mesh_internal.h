// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/bridge_mesh_internal.h: bridges and sweeps in space: where their points are, and how far they are
// from quadrilaterals. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "interval/exact_box.h"
#include "solids/micro/mesh/cage_cells_internal.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// How far a bridge may lie from its quadrilaterals if it is cut into n parts along an axis: bend / n^2 + crease / n.
struct BridgeError {
  std::array<double, 3> bend{}, crease{};
};

/// All functions REQUIRE a live ScopedUpward.
class BridgeMesh {
 public:
  /// REQUIRES a bridge in the parameters of the volume.
  BridgeMesh(const VVolume& volume, const MicroBridge& bridge);
  /// @param cell  a grid of the volume with one cell
  /// @param cap   of that cell, in the parameters of the volume
  BridgeMesh(const VVolume& volume, const MicroGrid& cell, const BezierSurface<Rational>& cap,
             const MicroSweep& sweep);

  BridgeError error() const;
  /// The least of the lengths of the bridge and of its end along both axes, approximate.
  double approx_size() const;
  /// Contains the image of the point with these parameters, in [0, 1].
  Box3 value(const std::array<Rational, 3>& at) const;

 private:
  // A box in one knot span, and its map from the unit cube.
  struct Part {
    ExactBox<3> box;
    CellMap map;
  };
  void add_parts(const VVolume& volume, const MicroGrid& grid);
  CellMapBounds map_bounds() const;
  std::array<Interval, 3> derivative_bounds(std::size_t axis, std::size_t order) const;

  BezierVolume<Rational> net_;
  std::vector<Part> parts_;
  /// By axes of the volume: knots in the box where the map may have a crease.
  std::array<int, 3> num_creases_{};
  /// The curve of a sweep, whose net does not depend on the third parameter.
  std::optional<std::array<TilePoint, 2>> curve_;
};

}  // namespace veritope::internal
