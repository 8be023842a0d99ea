// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/sheet_net_internal.h: a piece of a patch in doubles with bounds, and between which two parallel
// planes it lies. Internal to solids/classify.
#pragma once
#include <array>
#include <vector>

#include "solids/classify/ray_net_internal.h"

namespace veritope::internal {

class SheetNet {
 public:
  explicit SheetNet(const TensorForm& form);

  /// Contains the closed hull of the exact control points.
  Box3d hull() const;
  /// A normal of length 1 in the sum of absolute values, approximately that of the piece; zeros if it has none.
  Point3d normal() const;
  /// Contains n·p for all points of the hull. REQUIRES |n| at most 1 in the sum of absolute values.
  std::array<double, 2> range_along(const Point3d& n) const;
  /// Approximate.
  double length(std::size_t axis) const;
  /// This becomes the first half, the result is the second.
  SheetNet halve(std::size_t axis);

 private:
  const double* component(std::size_t k) const { return values_.data() + k * form_->count(); }
  Point3d at(std::size_t i) const;
  double greatest(std::size_t k) const;

  const TensorForm* form_;
  std::vector<double> values_;  // x, y, z, w
  std::array<double, 4> error_{};
};

/// Contains all points of the patch, in the coordinates of TensorForm::rounded, whose control points may lie far away.
Box3d tight_hull(const TensorForm& form);

}  // namespace veritope::internal
