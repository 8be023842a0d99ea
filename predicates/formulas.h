// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/formulas.h: each determinant once, over any ring. The filter (double), the interval tier, the exact tiers and the test
// that derives the filter's constant from its rounding errors all run these lines.
#pragma once

namespace veritope::formulas {

/// (b - a) x (c - a) = left - right; the determinant and the magnitude left + right of its absolute terms.
template <typename T>
struct Orient2d {
  T left, right;

  constexpr Orient2d(const T& ax, const T& ay, const T& bx, const T& by, const T& cx, const T& cy)
      : left((bx - ax) * (cy - ay)), right((by - ay) * (cx - ax)) {}
  constexpr T det() const { return left - right; }
  template <typename Abs>
  constexpr T magnitude(Abs abs) const {
    return abs(left) + abs(right);
  }
};

/// The normal u x v of a plane through p with directions u = q - p, v = r - p, and the magnitudes of its terms. Asked
/// about many points d: orient3d(p, q, r, d) = normal . (d - p).
template <typename T>
struct Plane3 {
  T px, py, pz;
  T yz, zy, zx, xz, xy, yx;  // products of a coordinate of u with one of v

  constexpr Plane3(const T& px_, const T& py_, const T& pz_, const T& qx, const T& qy, const T& qz,
                   const T& rx, const T& ry, const T& rz)
      : px(px_), py(py_), pz(pz_) {
    const T ux = qx - px, uy = qy - py, uz = qz - pz;
    const T vx = rx - px, vy = ry - py, vz = rz - pz;
    yz = uy * vz, zy = uz * vy;
    zx = uz * vx, xz = ux * vz;
    xy = ux * vy, yx = uy * vx;
  }
  constexpr T det(const T& wx, const T& wy, const T& wz) const {
    return (wx * (yz - zy) + wy * (zx - xz)) + wz * (xy - yx);
  }
  template <typename Abs>
  constexpr T magnitude(const T& wx, const T& wy, const T& wz, Abs abs) const {
    return (abs(wx) * (abs(yz) + abs(zy)) + abs(wy) * (abs(zx) + abs(xz))) +
           abs(wz) * (abs(xy) + abs(yx));
  }
};

}  // namespace veritope::formulas
