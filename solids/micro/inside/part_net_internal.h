// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/part_net_internal.h: the map of a box of parameters in interval Bezier form. Internal to
// solids/micro/inside.
#pragma once
#include <vector>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "splines/bezier.h"

namespace veritope::internal {

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
  /// How far off a coordinate of a point may be for a checker that computes in binary64, with errors bounded from the
  /// sizes of the numbers of the whole map (docs/certificates/micro-inside.md, section 10). No proof depends on it.
  double checkers_error() const { return checkers_error_; }

 private:
  PartNet(BezierVolume<Interval> net, double checkers_error)
      : net_(std::move(net)), checkers_error_(checkers_error) {}
  BezierVolume<Interval> net_;
  double checkers_error_ = 0;
};

}  // namespace veritope::internal
