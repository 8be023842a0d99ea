// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/hull_sides_internal.h: proves convex hulls of few points disjoint, by planes between them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "interval/interval.h"
#include "robust/base/box3d.h"
#include "robust/rational.h"

namespace veritope::internal {

/// Contains a point.
using HullPoint = std::array<Interval, 3>;

HullPoint hull_point(const std::array<Rational, 3>& p);
Box3d box_of_hull(std::span<const HullPoint> hull);

/// One hull, and directions in which others were found beyond it. They are searched for in floating point (steps
/// towards the point of the difference of the hulls that is nearest to 0, as in [GJK88]) and proved in intervals.
/// REQUIRES a live ScopedUpward.
class HullSides {
 public:
  /// The points must outlive the object. REQUIRES a point.
  explicit HullSides(std::span<const HullPoint> hull);

  /// True only if the hulls are disjoint. REQUIRES a point.
  bool is_apart_from(std::span<const HullPoint> other);

 private:
  struct Side {
    Point3d direction;
    double most;  // at least that of d·p over the hull
  };
  bool is_beyond(const Side& side, std::span<const HullPoint> other) const;
  bool try_direction(const Point3d& d, std::span<const HullPoint> other);

  std::span<const HullPoint> hull_;
  std::vector<Side> sides_;  // the last one that worked comes first
};

}  // namespace veritope::internal
