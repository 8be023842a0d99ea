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
  // Faces along the axes are the commonest degenerate ones.
  if (same_bits(a.x, b.x, c.x, d.x) || same_bits(a.y, b.y, c.y, d.y) ||
      same_bits(a.z, b.z, c.z, d.z)) {
    return Sign3::kZero;
  }
  return on_lattice<1>(a, b, c, d);
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
  const Sign3 s = on_lattice<2>(a, b, c, d);
  return is_certain(s) ? to_sign(s) : orient3d_integer(a, b, c, d);
}

Sign orient3d_integer(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  const auto x = to_integers<4>({a.x, b.x, c.x, d.x});
  const auto y = to_integers<4>({a.y, b.y, c.y, d.y});
  const auto z = to_integers<4>({a.z, b.z, c.z, d.z});
  const formulas::Plane3<Integer> plane(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]);
  return plane.det(x[3] - x[0], y[3] - y[0], z[3] - z[0]).sign();
}

Sign orient3d_after_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                           TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return orient3d_lattice(a, b, c, d); },
      [&] { return orient3d_interval(a, b, c, d); }, [&] { return orient3d_exact(a, b, c, d); });
}

}  // namespace veritope::internal
