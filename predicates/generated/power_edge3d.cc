// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/power_edge3d.formula: do not edit.
// clang-format off
#include "predicates/generated/power_edge3d.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 9> length_;
  std::array<Binary64, 3> length_2_;
  CommonScale length_scale;
};

Scaled scaled(const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) {
  Scaled s_;
  s_.length_ = odd_parts<9>({a.x, a.y, a.z, b.x, b.y, b.z, d.x, d.y, d.z});
  s_.length_2_ = odd_parts<3>({wa, wb, wd});
  s_.length_scale.include<1>(s_.length_);
  s_.length_scale.include<2>(s_.length_2_);
  return s_;
}

// The sign, if the inputs fit a lattice of that many bits.
template <int Bits>
Sign3 on_lattice(const Scaled& s_) {
  std::array<Bounded<Bits>, 9> length_;
  std::array<Bounded<2 * Bits>, 3> length_2_;
  if (!put<1, Bits>(s_.length_scale, s_.length_, length_)) return Sign3::kUncertain;
  if (!put<2, Bits>(s_.length_scale, s_.length_2_, length_2_)) return Sign3::kUncertain;
  const auto px = length_[0] - length_[6];
  const auto py = length_[1] - length_[7];
  const auto pz = length_[2] - length_[8];
  const auto qx = length_[3] - length_[6];
  const auto qy = length_[4] - length_[7];
  const auto qz = length_[5] - length_[8];
  const auto ux = length_[3] - length_[0];
  const auto uy = length_[4] - length_[1];
  const auto uz = length_[5] - length_[2];
  const auto da = length_2_[2] - length_2_[0];
  const auto db = length_2_[2] - length_2_[1];
  if constexpr (Bits == kOneLimbBits) {
    if (fits<30>(px) &&
        fits<30>(py) &&
        fits<30>(pz) &&
        fits<30>(qx) &&
        fits<30>(qy) &&
        fits<30>(qz) &&
        fits<30>(ux) &&
        fits<30>(uy) &&
        fits<30>(uz) &&
        fits<60>(da) &&
        fits<60>(db)) {
      const auto det_ = formulas::power_edge3d_det(
          narrowed<30>(px), narrowed<30>(py), narrowed<30>(pz), narrowed<30>(qx), narrowed<30>(qy),
          narrowed<30>(qz), narrowed<30>(ux), narrowed<30>(uy), narrowed<30>(uz), narrowed<60>(da),
          narrowed<60>(db));
      static_assert(decltype(det_)::kBits == 124);
      return to_sign3(sign_of(det_));
    }
  }
  const auto det_ = formulas::power_edge3d_det(px, py, pz, qx, qy, qz, ux, uy, uz, da, db);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 248 : 504));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 power_edge3d_lattice(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) noexcept {
  const Scaled s_ = scaled(a, wa, b, wb, d, wd);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign power_edge3d_exact(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) noexcept {
  using T = Wide<degree_limbs(4, 8)>;
  return formulas::power_edge3d_of<T>(
      {wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 1>(a.z), wide<T, 2>(wa), wide<T, 1>(b.x),
      wide<T, 1>(b.y), wide<T, 1>(b.z), wide<T, 2>(wb), wide<T, 1>(d.x), wide<T, 1>(d.y),
      wide<T, 1>(d.z), wide<T, 2>(wd)}).sign();
}

Sign3 power_edge3d_interval(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) noexcept {
  const std::array<double, 12> v_ = {a.x, a.y, a.z, wa, b.x, b.y, b.z, wb, d.x, d.y, d.z, wd};
  std::array<Interval, 12> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::power_edge3d_of<Interval>(w_).sign();
}

Sign power_edge3d_after_filter(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd,
      TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return power_edge3d_lattice(a, wa, b, wb, d, wd); },
      [&] { return power_edge3d_interval(a, wa, b, wb, d, wd); },
      [&] { return power_edge3d_exact(a, wa, b, wb, d, wd); });
}

}  // namespace veritope::internal
