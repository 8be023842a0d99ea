// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient3d.h"

#include "interval/interval.h"
#include "predicates/fixed_formulas.h"

namespace veritope::internal {
namespace {

// The sign, if each axis fits a lattice of L limbs.
template <int L>
Sign3 on_lattice(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  std::array<FixedInt<L>, 4> x, y, z;
  if (!to_lattice<L, 4>({a.x, b.x, c.x, d.x}, x) || !to_lattice<L, 4>({a.y, b.y, c.y, d.y}, y) ||
      !to_lattice<L, 4>({a.z, b.z, c.z, d.z}, z)) {
    return Sign3::kUncertain;
  }
  return to_sign3(orient3d_fixed<LatticeWidth<L>>(from_first(x), from_first(y), from_first(z)));
}

}  // namespace

Sign3 orient3d_lattice(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  // Faces perpendicular to an axis are the most common degenerate ones.
  if (same_bits(a.x, b.x, c.x, d.x) || same_bits(a.y, b.y, c.y, d.y) ||
      same_bits(a.z, b.z, c.z, d.z)) {
    return Sign3::kZero;
  }
  const Sign3 s = on_lattice<1>(a, b, c, d);
  if (is_certain(s)) return s;
  const std::array<double, 12> all{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z};
  return has_equal_points<3>(all) ? Sign3::kZero : on_lattice<2>(a, b, c, d);
}

Sign3 orient3d_interval(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  const ScopedUpward upward;
  const formulas::Plane3<Interval> plane(Interval(a.x), Interval(a.y), Interval(a.z), Interval(b.x),
                                         Interval(b.y), Interval(b.z), Interval(c.x), Interval(c.y),
                                         Interval(c.z));
  return plane.det(Interval(d.x) - plane.ax, Interval(d.y) - plane.ay, Interval(d.z) - plane.az)
      .sign();
}

Sign orient3d_exact(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  using T = Wide<degree_limbs(3, 3)>;  // six products
  const auto v = to_wide<T, 12>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z});
  const formulas::Plane3<T> plane(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]);
  return plane.det(v[9] - v[0], v[10] - v[1], v[11] - v[2]).sign();
}

Sign orient3d_after_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                           TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return orient3d_lattice(a, b, c, d); },
      [&] { return orient3d_interval(a, b, c, d); }, [&] { return orient3d_exact(a, b, c, d); });
}

}  // namespace veritope::internal
