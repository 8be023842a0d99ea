// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/fixed_formulas.h: the determinants of formulas.h on a lattice of L limbs (lattice.h).
// Every product is as wide as it needs to be; the static_asserts are the proof that nothing wraps
// around.
#pragma once
#include <array>

#include "predicates/lattice.h"
#include "robust/fixed_int.h"

namespace veritope::internal {

template <int L>
struct LatticeBudget {
  static constexpr int kDiff = bits_of_sum(2, lattice_bits(L));
  static constexpr int kProduct = bits_of_product(kDiff, kDiff);
  static constexpr int kMinor = bits_of_sum(2, kProduct);  // a b - c d, or a^2 + b^2
  static constexpr int kMinor3 = bits_of_sum(3, bits_of_product(kDiff, kMinor));
  static constexpr int kLift3 = bits_of_sum(3, kProduct);
};

/// x y - z w
template <int L>
[[gnu::always_inline]] inline FixedInt<2 * L> minor(const FixedInt<L>& x, const FixedInt<L>& y,
                                                    const FixedInt<L>& z, const FixedInt<L>& w) {
  return wide_product(x, y) - wide_product(z, w);
}

template <int L>
Sign orient2d_fixed(const std::array<FixedInt<L>, 3>& x, const std::array<FixedInt<L>, 3>& y) {
  static_assert(LatticeBudget<L>::kMinor < FixedInt<2 * L>::kBits);
  return minor<L>(x[1] - x[0], y[2] - y[0], y[1] - y[0], x[2] - x[0]).sign();
}

template <int L>
Sign orient3d_fixed(const std::array<FixedInt<L>, 4>& x, const std::array<FixedInt<L>, 4>& y,
                    const std::array<FixedInt<L>, 4>& z) {
  static_assert(LatticeBudget<L>::kMinor < FixedInt<2 * L>::kBits);
  static_assert(LatticeBudget<L>::kMinor3 < FixedInt<3 * L>::kBits);
  const FixedInt<L> ux = x[1] - x[0], uy = y[1] - y[0], uz = z[1] - z[0];
  const FixedInt<L> vx = x[2] - x[0], vy = y[2] - y[0], vz = z[2] - z[0];
  return (wide_product(x[3] - x[0], minor(uy, vz, uz, vy)) +
          wide_product(y[3] - y[0], minor(uz, vx, ux, vz)) +
          wide_product(z[3] - z[0], minor(ux, vy, uy, vx)))
      .sign();
}

template <int L>
Sign in_circle_fixed(const std::array<FixedInt<L>, 8>& c) {
  static_assert(LatticeBudget<L>::kMinor < FixedInt<2 * L>::kBits);
  static_assert(bits_of_sum(3, bits_of_product(LatticeBudget<L>::kMinor,
                                               LatticeBudget<L>::kMinor)) < FixedInt<4 * L>::kBits);
  const FixedInt<L> ax = c[0] - c[6], ay = c[1] - c[7], bx = c[2] - c[6], by = c[3] - c[7],
                    cx = c[4] - c[6], cy = c[5] - c[7];
  const auto lift = [](const FixedInt<L>& x, const FixedInt<L>& y) {
    return wide_product(x, x) + wide_product(y, y);
  };
  return (wide_product(lift(ax, ay), minor(bx, cy, cx, by)) +
          wide_product(lift(bx, by), minor(cx, ay, ax, cy)) +
          wide_product(lift(cx, cy), minor(ax, by, bx, ay)))
      .sign();
}

template <int L>
Sign in_sphere_fixed(const std::array<FixedInt<L>, 15>& c) {
  using Budget = LatticeBudget<L>;
  static_assert(Budget::kMinor < FixedInt<2 * L>::kBits && Budget::kLift3 < FixedInt<2 * L>::kBits);
  static_assert(Budget::kMinor3 < FixedInt<3 * L>::kBits);
  static_assert(bits_of_sum(4, bits_of_product(Budget::kLift3, Budget::kMinor3)) <
                FixedInt<5 * L>::kBits);
  std::array<FixedInt<L>, 4> x, y, z;
  for (int i = 0; i < 4; ++i) {
    x[i] = c[3 * i] - c[12], y[i] = c[3 * i + 1] - c[13], z[i] = c[3 * i + 2] - c[14];
  }
  const auto lift = [&](int i) {
    return wide_product(x[i], x[i]) + wide_product(y[i], y[i]) + wide_product(z[i], z[i]);
  };
  const auto m = [&](int i, int j) { return minor(x[i], y[j], x[j], y[i]); };
  const FixedInt<2 *L> ab = m(0, 1), bc = m(1, 2), cd = m(2, 3), da = m(3, 0), ac = m(0, 2),
                       bd = m(1, 3);
  const FixedInt<3 * L> abc =
      wide_product(z[0], bc) - wide_product(z[1], ac) + wide_product(z[2], ab);
  const FixedInt<3 * L> bcd =
      wide_product(z[1], cd) - wide_product(z[2], bd) + wide_product(z[3], bc);
  const FixedInt<3 * L> cda =
      wide_product(z[2], da) + wide_product(z[3], ac) + wide_product(z[0], cd);
  const FixedInt<3 * L> dab =
      wide_product(z[3], ab) + wide_product(z[0], bd) + wide_product(z[1], da);
  return (wide_product(lift(0), bcd) - wide_product(lift(1), cda) + wide_product(lift(2), dab) -
          wide_product(lift(3), abc))
      .sign();
}

}  // namespace veritope::internal
