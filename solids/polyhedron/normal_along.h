// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/normal_along.h: the sign of a facet's normal along an integer direction, in floating point with a
// bound. Bound: docs/bounds/normal_along.md.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/filter.h"

namespace veritope {
namespace formulas {

/// The normal n = (b - a) x (c - a) with the magnitudes s of its terms; n.d and the same of magnitudes.
template <typename T>
struct NormalAlong {
  T x, y, z;
  T sx, sy, sz;

  template <typename Abs>
  constexpr NormalAlong(const T& ax, const T& ay, const T& az, const T& bx, const T& by,
                        const T& bz, const T& cx, const T& cy, const T& cz, Abs abs)
      : NormalAlong(bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az, abs) {}
  /// The normal of the edges u = b - a and v = c - a.
  template <typename Abs>
  constexpr NormalAlong(const T& ux, const T& uy, const T& uz, const T& vx, const T& vy,
                        const T& vz, Abs abs) {
    const T yz = uy * vz, zy = uz * vy, zx = uz * vx, xz = ux * vz, xy = ux * vy, yx = uy * vx;
    x = yz - zy, y = zx - xz, z = xy - yx;
    sx = abs(yz) + abs(zy);
    sy = abs(zx) + abs(xz);
    sz = abs(xy) + abs(yx);
  }
  constexpr T det(const T& dx, const T& dy, const T& dz) const {
    return (dx * x + dy * y) + dz * z;
  }
  template <typename Abs>
  constexpr T magnitude(const T& dx, const T& dy, const T& dz, Abs abs) const {
    return (abs(dx) * sx + abs(dy) * sy) + abs(dz) * sz;
  }
};

}  // namespace formulas

namespace internal {
inline constexpr double kNormalAlongRel = 0x1.800000000000ap-51;
}  // namespace internal

/// The normal n = (b - a) x (c - a), rounded, with the magnitudes of its terms.
/// Claim    sign_along(d) is certain only if it is the exact sign of n.d.
/// Bound    |det - exact| <= (6u + O(u^2)) S + underflow, S = the sum of the absolute terms, u = 2^-53.
/// Derived  docs/bounds/normal_along.md, and again in tests/solids/normal_along_bound_test.cc.
/// Needs    finite points, |d_k| < 2^31, round to nearest, gradual underflow, no contraction (robust/base/fp_guard.h).
struct FacetNormal : formulas::NormalAlong<FilterReal> {
  FacetNormal(const Vec3d& a, const Vec3d& b, const Vec3d& c)
      : NormalAlong(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z,
                    [](double v) { return std::abs(v); }) {}

  Sign3 sign_along(const std::array<std::int32_t, 3>& d) const {
    const double dx = d[0], dy = d[1], dz = d[2];
    const double value = det(dx, dy, dz);
    const double s = magnitude(dx, dy, dz, [](double v) { return std::abs(v); });
    const double bound = internal::kNormalAlongRel * s;
    return sign_beyond(value, bound);
  }
};

}  // namespace veritope
