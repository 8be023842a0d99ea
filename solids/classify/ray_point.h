// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/ray_point.h: a point from which rays start, in doubles with bounds and, on demand, in
// integers.
#pragma once
#include <array>
#include <cstddef>

#include "predicates/vec.h"
#include "robust/base/box3d.h"
#include "robust/integer.h"
#include "solids/classify/point_answer.h"

namespace veritope {

class RayPoint {
 public:
  /// @param scale  coordinates in doubles are divided by 2^scale, as those of TensorForm. REQUIRES finite coordinates.
  RayPoint(const Vec3d& p, int scale);
  RayPoint(const ExactPoint& p, int scale);

  /// The rounded coordinates.
  const Point3d& rounded() const { return rounded_; }
  /// Contains the point.
  const Box3d& box() const { return box_; }

  /// The point itself, not divided.
  const ExactPoint& exact() const;
  /// Its coordinates over one denominator > 0.
  struct Fractions {
    std::array<Integer, 3> numerators;
    Integer denominator{1};
  };
  Fractions fractions() const;

 private:
  Vec3d given_;
  mutable bool has_exact_ = false;
  mutable ExactPoint exact_;
  Point3d rounded_{};
  Box3d box_{};
};

}  // namespace veritope
