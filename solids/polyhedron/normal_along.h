// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/normal_along.h: the sign of a facet's normal along an integer direction, in floating point with a bound.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"

namespace veritope {

/// The normal n = (b - a) x (c - a), rounded, with the magnitudes of its terms.
/// Claim    sign_along(d) is certain only if it is the exact sign of n.d.
/// Bound    Each component is an orient2d: |n_k - exact| <= (3u + 6u^2 + ...) S_k + 2^-1074, S_k the sum of its two absolute
///          products as computed. |n_k| <= (1 + u) S_k. Products with the exact integers d_k and the two additions
///          round at most 3 times: |n.d - exact| <= (3u + 3u + O(u^2)) sum |d_k| S_k + 3 max|d_k| 2^-1073, and summing
///          the bound itself costs a factor (1 + 6u). 8u = 2^-50 covers it while sum |d_k| S_k >= 2^-900; overflow makes every
///          comparison false.
/// Needs    finite points, |d_k| < 2^31, round to nearest, no contraction.
struct FacetNormal {
  double x, y, z;
  double sx, sy, sz;

  FacetNormal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const double yz = uy * vz, zy = uz * vy, zx = uz * vx, xz = ux * vz, xy = ux * vy, yx = uy * vx;
    x = yz - zy, y = zx - xz, z = xy - yx;
    sx = std::abs(yz) + std::abs(zy);
    sy = std::abs(zx) + std::abs(xz);
    sz = std::abs(xy) + std::abs(yx);
  }

  Sign3 sign_along(const std::array<std::int32_t, 3>& d) const {
    const double dx = d[0], dy = d[1], dz = d[2];
    const double value = dx * x + dy * y + dz * z;
    const double s = std::abs(dx) * sx + std::abs(dy) * sy + std::abs(dz) * sz;
    if (!(s >= 0x1p-900)) return Sign3::kUncertain;
    const double bound = 0x1p-50 * s;
    if (value > bound) return Sign3::kPositive;
    return -value > bound ? Sign3::kNegative : Sign3::kUncertain;
  }
};

}  // namespace veritope
