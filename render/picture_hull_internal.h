// SPDX-License-Identifier: LGPL-3.0-or-later
// render/picture_hull_internal.h: the least rectangle around points of a picture.
#pragma once
#include <algorithm>
#include <limits>

#include "render/parallel_view_internal.h"

namespace veritope::internal {

/// In samples; left > right if there is no point.
class PictureHull {
 public:
  void add(const SamplePoint& p, double radius = 0) {
    box_ = {std::min(box_.left, p.x - radius), std::min(box_.top, p.y - radius),
            std::max(box_.right, p.x + radius), std::max(box_.bottom, p.y + radius)};
  }
  const PictureBox& box() const { return box_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  PictureBox box_{kInfinity, kInfinity, -kInfinity, -kInfinity};
};

}  // namespace veritope::internal
