// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/scaled_point_internal.h: a point with any rational coordinates over one denominator, and its
// orientations with points of binary64. Internal to solids/classify.
#pragma once
#include <array>
#include <cstddef>

#include "predicates/projection.h"
#include "predicates/vec.h"
#include "robust/base/box3d.h"
#include "robust/dyadic.h"
#include "solids/classify/point_answer.h"

namespace veritope::internal {

/// The point at / weight, weight > 0. Orientations are computed in a ring, without a common denominator anywhere.
struct ScaledPoint {
  explicit ScaledPoint(const ExactPoint& p);

  std::array<Dyadic, 3> at;
  Dyadic weight;
  Vec3d rounded;  ///< finite; that of a point of a box of binary64 lies in the box
  double slack =
      0;  ///< no coordinate of a point that binary64 does not overflow differs from `rounded` by more

  /// at[k] - c weight
  Dyadic beyond(std::size_t k, double c) const { return at[k] - Dyadic::from_double(c) * weight; }
  /// The sign of the coordinate minus c.
  Sign compare(std::size_t k, double c) const { return beyond(k, c).sign(); }
};

/// As predicates/orient3d.h.
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const ScaledPoint& d);
/// As predicates/orient2d.h, for points seen along an axis as drop_axis shows them.
Sign orient2d(const Vec3d& a, const Vec3d& b, const ScaledPoint& c, int axis);
inline Sign orient2d(const Vec3d& a, const Vec3d& b, const Vec3d& c, int axis) {
  return veritope::orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis));
}

bool is_in(const Box3d& box, const ScaledPoint& q);
inline bool is_in(const Box3d& box, const Vec3d& q) {
  const Point3d p = to_point(q);
  return is_inside({p, p}, box);
}

}  // namespace veritope::internal
