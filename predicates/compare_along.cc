// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/compare_along.h"

#include "interval/interval.h"
#include "predicates/fixed_formulas.h"

namespace veritope::internal {

Sign3 compare_along_lattice(const Vec3d& direction, const Vec3d& p, const Vec3d& q) noexcept {
  std::array<FixedInt<1>, 3> d;
  std::array<FixedInt<1>, 6> v;
  if (!to_lattice<1, 3>({direction.x, direction.y, direction.z}, d) ||
      !to_lattice<1, 6>({p.x, p.y, p.z, q.x, q.y, q.z}, v)) {
    return Sign3::kUncertain;
  }
  static_assert(
      bits_of_sum(3, bits_of_product(lattice_bits(1), LatticeBudget{lattice_bits(1) + 1}.diff)) <
      FixedInt<2>::kBits);
  return to_sign3((wide_product(d[0], v[0] - v[3]) + wide_product(d[1], v[1] - v[4]) +
                   wide_product(d[2], v[2] - v[5]))
                      .sign());
}

Sign3 compare_along_interval(const Vec3d& direction, const Vec3d& p, const Vec3d& q) noexcept {
  const ScopedUpward upward;
  return formulas::CompareAlong<Interval>(
             Interval(direction.x), Interval(direction.y), Interval(direction.z), Interval(p.x),
             Interval(p.y), Interval(p.z), Interval(q.x), Interval(q.y), Interval(q.z))
      .det()
      .sign();
}

Sign compare_along_exact(const Vec3d& direction, const Vec3d& p, const Vec3d& q) noexcept {
  using T = Wide<degree_limbs(2, 2)>;  // three products
  const auto d = to_wide<T, 3>({direction.x, direction.y, direction.z});
  const auto v = to_wide<T, 6>({p.x, p.y, p.z, q.x, q.y, q.z});
  return formulas::CompareAlong<T>(d[0], d[1], d[2], v[0], v[1], v[2], v[3], v[4], v[5])
      .det()
      .sign();
}

Sign compare_along_after_filter(const Vec3d& direction, const Vec3d& p, const Vec3d& q,
                                TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return compare_along_lattice(direction, p, q); },
      [&] { return compare_along_interval(direction, p, q); },
      [&] { return compare_along_exact(direction, p, q); });
}

}  // namespace veritope::internal
