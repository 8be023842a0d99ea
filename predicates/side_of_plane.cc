// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/side_of_plane.h"

#include "interval/interval.h"
#include "predicates/fixed_formulas.h"

namespace veritope::internal {
namespace {

// (normal, offset) . (p, 1): both factors are lattice points, each on its own scale.
std::array<double, 4> left(const PlaneCoefficients& plane) {
  return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
}
std::array<double, 4> right(const Vec3d& p) { return {p.x, p.y, p.z, 1}; }

}  // namespace

Sign3 side_of_plane_lattice(const PlaneCoefficients& plane, const Vec3d& p) noexcept {
  std::array<FixedInt<1>, 4> a, b;
  if (!to_lattice<1, 4>(left(plane), a) || !to_lattice<1, 4>(right(p), b)) return Sign3::kUncertain;
  static_assert(bits_of_sum(4, bits_of_product(lattice_bits(1), lattice_bits(1))) <
                FixedInt<2>::kBits);
  return to_sign3((wide_product(a[0], b[0]) + wide_product(a[1], b[1]) + wide_product(a[2], b[2]) +
                   wide_product(a[3], b[3]))
                      .sign());
}

Sign3 side_of_plane_interval(const PlaneCoefficients& plane, const Vec3d& p) noexcept {
  const ScopedUpward upward;
  return formulas::SideOfPlane<Interval>(Interval(plane.normal.x), Interval(plane.normal.y),
                                         Interval(plane.normal.z), Interval(plane.offset),
                                         Interval(p.x), Interval(p.y), Interval(p.z))
      .det()
      .sign();
}

Sign side_of_plane_exact(const PlaneCoefficients& plane, const Vec3d& p) noexcept {
  using T = Wide<degree_limbs(2, 2)>;  // four products
  const auto a = to_wide<T, 4>(left(plane)), b = to_wide<T, 4>(right(p));
  return ((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])).sign();
}

Sign side_of_plane_after_filter(const PlaneCoefficients& plane, const Vec3d& p,
                                TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return side_of_plane_lattice(plane, p); },
      [&] { return side_of_plane_interval(plane, p); },
      [&] { return side_of_plane_exact(plane, p); });
}

}  // namespace veritope::internal
