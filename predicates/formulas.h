// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/formulas.h: each determinant, written once over any ring. The filter (double), the interval tier, the
// slowest exact tier (Integer) and the tests that derive the filters' constants from the roundings in these very lines
// all instantiate it.
//
// det() is the determinant; magnitude(abs) is the same expression with every term replaced by its
// absolute value and every difference of terms by a sum, so that |det| <= magnitude holds after
// rounding, too: rounding is monotone.
#pragma once

namespace veritope::formulas {

/// x * x; rings that know better (Interval) bring their own.
template <typename T>
constexpr T sqr(const T& x) {
  return x * x;
}

/// (b - a) x (c - a)
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
  /// Equal to magnitude if left and right have the same sign; smaller where nothing cancels in det()
  /// anyway. Takes one fewer operation.
  template <typename Abs>
  constexpr T cancelling_magnitude(Abs abs) const {
    return abs(left + right);
  }
};

/// The normal (b - a) x (c - a) of a plane, kept as products, and its value at a further point:
/// with w = d - a, det(w) = det(b - a, c - a, d - a).
template <typename T>
struct Plane3 {
  T ax, ay, az;
  T yz, zy, zx, xz, xy, yx;  // products of a coordinate of b - a with one of c - a

  constexpr Plane3(const T& ax_, const T& ay_, const T& az_, const T& bx, const T& by, const T& bz,
                   const T& cx, const T& cy, const T& cz)
      : ax(ax_), ay(ay_), az(az_) {
    const T ux = bx - ax, uy = by - ay, uz = bz - az;
    const T vx = cx - ax, vy = cy - ay, vz = cz - az;
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
  /// A bound on each factor that a term of the normal is multiplied with.
  template <typename Abs>
  constexpr T size(const T& wx, const T& wy, const T& wz, Abs abs) const {
    return (abs(wx) + abs(wy)) + abs(wz);
  }
};

/// The lifted determinant of a - d, b - d, c - d: > 0 iff d lies inside the circle through the
/// counter-clockwise a, b, c.
template <typename T>
struct InCircle {
  T bc, cb, ca, ac, ab, ba;  // products: bc = (b - d).x * (c - d).y
  T a_lift, b_lift, c_lift;  // squared distances from d

  constexpr InCircle(const T& ax_, const T& ay_, const T& bx_, const T& by_, const T& cx_,
                     const T& cy_, const T& dx, const T& dy) {
    const T ax = ax_ - dx, ay = ay_ - dy, bx = bx_ - dx, by = by_ - dy, cx = cx_ - dx,
            cy = cy_ - dy;
    bc = bx * cy, cb = cx * by;
    ca = cx * ay, ac = ax * cy;
    ab = ax * by, ba = bx * ay;
    a_lift = sqr(ax) + sqr(ay), b_lift = sqr(bx) + sqr(by), c_lift = sqr(cx) + sqr(cy);
  }
  constexpr T det() const { return (a_lift * (bc - cb) + b_lift * (ca - ac)) + c_lift * (ab - ba); }
  template <typename Abs>
  constexpr T magnitude(Abs abs) const {
    return (a_lift * (abs(bc) + abs(cb)) + b_lift * (abs(ca) + abs(ac))) +
           c_lift * (abs(ab) + abs(ba));
  }
  constexpr T size() const { return (a_lift + b_lift) + c_lift; }
};

/// The lifted determinant of a - e, b - e, c - e, d - e, signed so that it is > 0 iff e lies inside
/// the sphere through a, b, c, d with orient3d(a, b, c, d) > 0.
template <typename T>
struct InSphere {
  T az, bz, cz, dz;
  T ab, ba, bc, cb, cd, dc, da, ad, ac, ca, bd, db;  // ab = (a - e).x * (b - e).y
  T a_lift, b_lift, c_lift, d_lift;

  constexpr InSphere(const T& ax_, const T& ay_, const T& az_, const T& bx_, const T& by_,
                     const T& bz_, const T& cx_, const T& cy_, const T& cz_, const T& dx_,
                     const T& dy_, const T& dz_, const T& ex, const T& ey, const T& ez) {
    const T ax = ax_ - ex, ay = ay_ - ey, bx = bx_ - ex, by = by_ - ey;
    const T cx = cx_ - ex, cy = cy_ - ey, dx = dx_ - ex, dy = dy_ - ey;
    az = az_ - ez, bz = bz_ - ez, cz = cz_ - ez, dz = dz_ - ez;
    ab = ax * by, ba = bx * ay;
    bc = bx * cy, cb = cx * by;
    cd = cx * dy, dc = dx * cy;
    da = dx * ay, ad = ax * dy;
    ac = ax * cy, ca = cx * ay;
    bd = bx * dy, db = dx * by;
    a_lift = (sqr(ax) + sqr(ay)) + sqr(az), b_lift = (sqr(bx) + sqr(by)) + sqr(bz);
    c_lift = (sqr(cx) + sqr(cy)) + sqr(cz), d_lift = (sqr(dx) + sqr(dy)) + sqr(dz);
  }
  constexpr T det() const {
    const T m_ab = ab - ba, m_bc = bc - cb, m_cd = cd - dc, m_da = da - ad, m_ac = ac - ca,
            m_bd = bd - db;
    const T abc = (az * m_bc - bz * m_ac) + cz * m_ab, bcd = (bz * m_cd - cz * m_bd) + dz * m_bc;
    const T cda = (cz * m_da + dz * m_ac) + az * m_cd, dab = (dz * m_ab + az * m_bd) + bz * m_da;
    return (a_lift * bcd - b_lift * cda) + (c_lift * dab - d_lift * abc);
  }
  template <typename Abs>
  constexpr T magnitude(Abs abs) const {
    const T a = abs(az), b = abs(bz), c = abs(cz), d = abs(dz);
    const T m_ab = abs(ab) + abs(ba), m_bc = abs(bc) + abs(cb), m_cd = abs(cd) + abs(dc);
    const T m_da = abs(da) + abs(ad), m_ac = abs(ac) + abs(ca), m_bd = abs(bd) + abs(db);
    const T abc = (a * m_bc + b * m_ac) + c * m_ab, bcd = (b * m_cd + c * m_bd) + d * m_bc;
    const T cda = (c * m_da + d * m_ac) + a * m_cd, dab = (d * m_ab + a * m_bd) + b * m_da;
    return (a_lift * bcd + b_lift * cda) + (c_lift * dab + d_lift * abc);
  }
};

/// A bound for differences of at most x, y, z along the axes: before rounding, InSphere's magnitude is at
/// most 24 times this one, which has a fifth of the operations.
template <typename T>
struct InSphereBox {
  T volume, lift;

  constexpr InSphereBox(const T& x, const T& y, const T& z)
      : volume((x * y) * z), lift((sqr(x) + sqr(y)) + sqr(z)) {}
  constexpr T magnitude() const { return volume * lift; }
  constexpr T size() const { return sqr(lift); }
};

/// n . p + k
template <typename T>
struct SideOfPlane {
  T x, y, z, k;

  constexpr SideOfPlane(const T& nx, const T& ny, const T& nz, const T& k_, const T& px,
                        const T& py, const T& pz)
      : x(nx * px), y(ny * py), z(nz * pz), k(k_) {}
  constexpr T det() const { return ((x + y) + z) + k; }
  template <typename Abs>
  constexpr T magnitude(Abs abs) const {
    return ((abs(x) + abs(y)) + abs(z)) + abs(k);
  }
};

/// direction . (p - q)
template <typename T>
struct CompareAlong {
  T x, y, z;

  constexpr CompareAlong(const T& dx, const T& dy, const T& dz, const T& px, const T& py,
                         const T& pz, const T& qx, const T& qy, const T& qz)
      : x(dx * (px - qx)), y(dy * (py - qy)), z(dz * (pz - qz)) {}
  constexpr T det() const { return (x + y) + z; }
  template <typename Abs>
  constexpr T magnitude(Abs abs) const {
    return (abs(x) + abs(y)) + abs(z);
  }
};

}  // namespace veritope::formulas
