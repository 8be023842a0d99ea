// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/implicit_predicates.h: the predicates on explicit and implicit points in every combination. All are exact
// for all finite coordinates and weights.
// Bound: docs/bounds/implicit_point.md.  Design: docs/design/0007-implicit-points.md.
#pragma once
#include "predicates/compare_along.h"
#include "predicates/implicit_kinds.h"
#include "predicates/side_of_plane.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"

namespace veritope {

// Each answers as the predicate of the same name on explicit points does, with the same laws, and is that predicate
// where all points are explicit. REQUIRES finite explicit points. Throws InternalError for a point that is not defined.
// Allocates only if numbers of more than 44 limbs (112 in in_circle and in_sphere) arise, which never happens with
// 60-bit coordinates.

Sign orient3d(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, const AnyPoint3& d,
              TierCounts* tally = nullptr);
Sign in_sphere(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, const AnyPoint3& d,
               const AnyPoint3& e, TierCounts* tally = nullptr);
/// orient2d of the points without their coordinate `axis`, as drop_axis(p, axis) has them.
Sign orient2d_projected(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, int axis,
                        TierCounts* tally = nullptr);
/// The sign of direction . (p - q).
Sign compare_along(const Vec3d& direction, const AnyPoint3& p, const AnyPoint3& q,
                   TierCounts* tally = nullptr);
Sign side_of_plane(const PlaneCoefficients& plane, const AnyPoint3& p, TierCounts* tally = nullptr);
/// The sign of p - q on an axis: 0, 1 or 2.
Sign compare_axis(const AnyPoint3& p, const AnyPoint3& q, int axis, TierCounts* tally = nullptr);
/// The sign of p - q on the first axis on which they differ; zero iff they coincide.
Sign compare_lexicographic(const AnyPoint3& p, const AnyPoint3& q, TierCounts* tally = nullptr);

Sign orient2d(const AnyPoint2& a, const AnyPoint2& b, const AnyPoint2& c,
              TierCounts* tally = nullptr);
Sign in_circle(const AnyPoint2& a, const AnyPoint2& b, const AnyPoint2& c, const AnyPoint2& d,
               TierCounts* tally = nullptr);
/// The sign of direction . (p - q).
Sign compare_along(const Vec2d& direction, const AnyPoint2& p, const AnyPoint2& q,
                   TierCounts* tally = nullptr);
/// The sign of p - q on an axis: 0 or 1.
Sign compare_axis(const AnyPoint2& p, const AnyPoint2& q, int axis, TierCounts* tally = nullptr);
Sign compare_lexicographic(const AnyPoint2& p, const AnyPoint2& q, TierCounts* tally = nullptr);

inline Sign compare_x(const AnyPoint3& p, const AnyPoint3& q) { return compare_axis(p, q, 0); }
inline Sign compare_y(const AnyPoint3& p, const AnyPoint3& q) { return compare_axis(p, q, 1); }
inline Sign compare_z(const AnyPoint3& p, const AnyPoint3& q) { return compare_axis(p, q, 2); }
inline bool coincide(const AnyPoint3& p, const AnyPoint3& q) {
  return compare_lexicographic(p, q) == Sign::kZero;
}
inline Sign compare_x(const AnyPoint2& p, const AnyPoint2& q) { return compare_axis(p, q, 0); }
inline Sign compare_y(const AnyPoint2& p, const AnyPoint2& q) { return compare_axis(p, q, 1); }
inline bool coincide(const AnyPoint2& p, const AnyPoint2& q) {
  return compare_lexicographic(p, q) == Sign::kZero;
}

}  // namespace veritope
