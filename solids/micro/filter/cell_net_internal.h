// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/cell_net_internal.h: the map of a cell, or of a block of cells, in interval Bezier form. Internal
// to solids/micro/filter.
#pragma once
#include <array>
#include <utility>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "robust/base/box3d.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// Bounds of absolute values over [0,1]^3: first[c][i] of the derivative of coordinate c along axis i, second[c][i][j]
/// of its derivatives along i and j. Infinite where a weight may be 0.
struct MapBounds {
  std::array<Point3d, 3> first{};
  std::array<std::array<Point3d, 3>, 3> second{};
};

/// All functions REQUIRE a live ScopedUpward.
class CellNet {
 public:
  /// REQUIRES three coordinates, and a weight if the map is rational.
  explicit CellNet(const BezierVolume<Rational>& map);

  /// Contains the map's values on the box, and lies in hull(). REQUIRES a box in [0,1]^3.
  Box3 values(const Box3& at) const;
  /// The box of the control points, which contains all values; not finite if a weight may be 0 or less.
  const Box3d& hull() const { return hull_; }
  MapBounds bounds() const;
  /// The map on both parts of an axis that is cut at t, 0 < t < 1, each as a map of [0,1]^3.
  std::pair<CellNet, CellNet> halves(std::size_t axis, const Interval& t) const;

 private:
  explicit CellNet(BezierVolume<Interval> net);
  void find_hull();

  BezierVolume<Interval> net_;
  Box3d hull_;
};

inline Box3d outer_box(const Box3& b) {
  return {{b[0].lo(), b[1].lo(), b[2].lo()}, {b[0].hi(), b[1].hi(), b[2].hi()}};
}

}  // namespace veritope::internal
