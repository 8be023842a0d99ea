// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/in_sphere.h"

#include "interval/interval.h"
#include "predicates/fixed_formulas.h"

namespace veritope::internal {
namespace {

using Coordinates = std::array<double, 15>;

Coordinates coordinates(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                        const Vec3d& e) {
  return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z};
}

// The sign, if all coordinates fit one lattice of L limbs.
template <int L>
Sign3 on_lattice(const Coordinates& c) {
  std::array<FixedInt<L>, 15> v;
  if (!to_lattice<L, 15>(c, v)) return Sign3::kUncertain;
  auto d = from_last<3>(v);
  if constexpr (L == 1) {
    const int bits = shorten(d);
    if (bits <= Tiny::kBudget.diff) return to_sign3(in_sphere_fixed<Tiny>(d));
    if (bits <= Short::kBudget.diff) return to_sign3(in_sphere_fixed<Short>(d));
  }
  return to_sign3(in_sphere_fixed<LatticeWidth<L>>(d));
}

template <typename T>
formulas::InSphere<T> formula(const std::array<T, 15>& v) {
  return {v[0], v[1], v[2],  v[3],  v[4],  v[5],  v[6], v[7],
          v[8], v[9], v[10], v[11], v[12], v[13], v[14]};
}

}  // namespace

Sign3 in_sphere_lattice(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                        const Vec3d& e) noexcept {
  const Coordinates v = coordinates(a, b, c, d, e);
  if (are_corners_of_a_box<3>(v)) return Sign3::kZero;
  const Sign3 s = on_lattice<1>(v);
  if (is_certain(s)) return s;
  return has_equal_points<3>(v) ? Sign3::kZero : on_lattice<2>(v);
}

Sign3 in_sphere_interval(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                         const Vec3d& e) noexcept {
  const Coordinates v = coordinates(a, b, c, d, e);
  std::array<Interval, 15> w;
  for (int i = 0; i < 15; ++i) w[i] = Interval(v[i]);
  const ScopedUpward upward;
  return formula<Interval>(w).det().sign();
}

Sign in_sphere_exact(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                     const Vec3d& e) noexcept {
  using T = Wide<degree_limbs(5, 7)>;  // 72 products
  return formula<T>(to_wide<T, 15>(coordinates(a, b, c, d, e))).det().sign();
}

Sign in_sphere_after_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                            const Vec3d& e, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return in_sphere_lattice(a, b, c, d, e); },
      [&] { return in_sphere_interval(a, b, c, d, e); },
      [&] { return in_sphere_exact(a, b, c, d, e); });
}

}  // namespace veritope::internal
