// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/rational_orient_internal.h: orientations of points with any rational coordinates: slow, for points
// that binary64 does not have. Internal to solids/classify.
#pragma once
#include <cstddef>

#include "predicates/projection.h"
#include "predicates/vec.h"
#include "solids/classify/point_answer.h"

namespace veritope::internal {

inline ExactPoint to_rational(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}

/// As predicates/orient3d.h.
inline Sign orient3d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                     const ExactPoint& d) {
  const auto minus_a = [&](const ExactPoint& p) {
    return ExactPoint{p[0] - a[0], p[1] - a[1], p[2] - a[2]};
  };
  const ExactPoint u = minus_a(b), v = minus_a(c), w = minus_a(d);
  const Rational x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2],
                 z = u[0] * v[1] - u[1] * v[0];
  return (x * w[0] + y * w[1] + z * w[2]).sign();
}

/// As predicates/orient2d.h, for points seen along an axis as drop_axis shows them.
inline Sign orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis) {
  const auto p = static_cast<std::size_t>((axis + 1) % 3),
             q = static_cast<std::size_t>((axis + 2) % 3);
  return ((b[p] - a[p]) * (c[q] - a[q]) - (b[q] - a[q]) * (c[p] - a[p])).sign();
}

inline Sign orient2d(const Vec3d& a, const Vec3d& b, const Vec3d& c, int axis) {
  return veritope::orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis));
}

}  // namespace veritope::internal
