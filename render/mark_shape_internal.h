// SPDX-License-Identifier: LGPL-3.0-or-later
// render/mark_shape_internal.h: which points of a picture lie in a mark, and how deep it is there.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "render/flat_scene_internal.h"

namespace veritope::internal {

/// A mark, asked for one point of the picture after the other. Keeps a reference to it.
class MarkShape {
 public:
  explicit MarkShape(const FlatMark& mark)
      : mark_(mark),
        dx_(mark.b.x - mark.a.x),
        dy_(mark.b.y - mark.a.y),
        square_(dx_ * dx_ + dy_ * dy_) {}

  double radius_of_rim() const { return mark_.radius + kRim; }
  /// An interval of x that contains all points of the mark and its rim in a row.
  std::array<double, 2> range_in_row(double y) const {
    double from = 0, to = 1;
    if (std::abs(dy_) > radius_of_rim()) {
      const double s = (y - radius_of_rim() - mark_.a.y) / dy_,
                   t = (y + radius_of_rim() - mark_.a.y) / dy_;
      from = std::clamp(std::min(s, t), 0.0, 1.0), to = std::clamp(std::max(s, t), 0.0, 1.0);
    }
    const double p = mark_.a.x + from * dx_, q = mark_.a.x + to * dx_;
    return {std::min(p, q) - radius_of_rim() - 1, std::max(p, q) + radius_of_rim() + 1};
  }
  /// Where the point of the segment nearest to (x, y) is, from 0 at a to 1 at b. A segment that looks like a point is
  /// seen from its near end.
  double nearest(double x, double y) const {
    constexpr double kShort = 0x1p-40;  // in pixels squared
    if (square_ < kShort) return mark_.a.depth <= mark_.b.depth ? 0 : 1;
    return std::clamp(((x - mark_.a.x) * dx_ + (y - mark_.a.y) * dy_) / square_, 0.0, 1.0);
  }
  double squared_distance(double x, double y, double at) const {
    const double u = x - (mark_.a.x + at * dx_), v = y - (mark_.a.y + at * dy_);
    return u * u + v * v;
  }
  double depth(double at) const {
    return std::clamp(mark_.a.depth + at * (mark_.b.depth - mark_.a.depth), 0.0, kDeepest);
  }

 private:
  const FlatMark& mark_;
  double dx_, dy_, square_;
};

}  // namespace veritope::internal
