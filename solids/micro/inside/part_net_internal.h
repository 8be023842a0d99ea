// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/part_net_internal.h: the map of a box of parameters in interval Bezier form, and the points of a
// node of docs/certificates/micro-inside.md, section 3. Internal to solids/micro/inside.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "robust/base/box3d.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// Enclosures of points, as middles and one radius for each coordinate: |q[c] - middle[c]| <= radius[c].
struct NodePoints {
  std::array<std::vector<double>, 3> middles;
  Point3d radius{};
  Box3d box = empty_box();  ///< around all of them

  std::size_t size() const { return middles[0].size(); }
  /// REQUIRES a live ScopedUpward.
  void assign(const std::vector<Box3>& points);
};

/// All functions REQUIRE a live ScopedUpward.
class PartNet {
 public:
  /// REQUIRES three coordinates, and a weight if the map is rational.
  explicit PartNet(const BezierVolume<Rational>& map);

  /// The map on a part of [0,1]^3, as a map of [0,1]^3: contains the coefficients for all parts whose begins and ends
  /// lie in the intervals. REQUIRES intervals that meet [0,1]; what is beyond is cut off.
  PartNet part(const Box3& begin, const Box3& end) const;
  /// The coefficients, divided by their weights; false if a weight may be 0 or less.
  bool points(std::vector<Box3>* out) const;
  /// Encloses the map's value. REQUIRES a box that meets [0,1]^3, and positive weights.
  Box3 value(const Box3& at) const;

 private:
  explicit PartNet(BezierVolume<Interval> net) : net_(std::move(net)) {}
  BezierVolume<Interval> net_;
};

}  // namespace veritope::internal
