// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/compare_distance3d.formula: do not edit.
// clang-format off
#include "predicates/generated/compare_distance3d.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 9> length_;
  CommonScale length_scale;
};

Scaled scaled(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  Scaled s_;
  s_.length_ = odd_parts<9>({p.x, p.y, p.z, a.x, a.y, a.z, b.x, b.y, b.z});
  s_.length_scale.include<1>(s_.length_);
  return s_;
}

// The sign, if the inputs fit a lattice of that many bits.
template <int Bits>
Sign3 on_lattice(const Scaled& s_) {
  std::array<Bounded<Bits>, 9> length_;
  if (!put<1, Bits>(s_.length_scale, s_.length_, length_)) return Sign3::kUncertain;
  const auto ux = length_[3] - length_[6];
  const auto uy = length_[4] - length_[7];
  const auto uz = length_[5] - length_[8];
  const auto vx = length_[3] - length_[0];
  const auto vy = length_[4] - length_[1];
  const auto vz = length_[5] - length_[2];
  const auto wx = length_[6] - length_[0];
  const auto wy = length_[7] - length_[1];
  const auto wz = length_[8] - length_[2];
  const auto det_ = formulas::compare_distance3d_det(ux, uy, uz, vx, vy, vz, wx, wy, wz);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 125 : 253));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 compare_distance3d_lattice(const Vec3d& p, const Vec3d& a, const Vec3d& b) noexcept {
  const Scaled s_ = scaled(p, a, b);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign compare_distance3d_exact(const Vec3d& p, const Vec3d& a, const Vec3d& b) noexcept {
  using T = Wide<degree_limbs(2, 5)>;
  return formulas::compare_distance3d_of<T>(
      {wide<T, 1>(p.x), wide<T, 1>(p.y), wide<T, 1>(p.z), wide<T, 1>(a.x), wide<T, 1>(a.y),
      wide<T, 1>(a.z), wide<T, 1>(b.x), wide<T, 1>(b.y), wide<T, 1>(b.z)}).sign();
}

Sign3 compare_distance3d_interval(const Vec3d& p, const Vec3d& a, const Vec3d& b) noexcept {
  const std::array<double, 9> v_ = {p.x, p.y, p.z, a.x, a.y, a.z, b.x, b.y, b.z};
  std::array<Interval, 9> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::compare_distance3d_of<Interval>(w_).sign();
}

Sign compare_distance3d_after_filter(
      const Vec3d& p, const Vec3d& a, const Vec3d& b, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return compare_distance3d_lattice(p, a, b); },
      [&] { return compare_distance3d_interval(p, a, b); },
      [&] { return compare_distance3d_exact(p, a, b); });
}

}  // namespace veritope::internal
