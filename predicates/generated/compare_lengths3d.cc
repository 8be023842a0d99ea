// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/compare_lengths3d.formula: do not edit.
// clang-format off
#include "predicates/generated/compare_lengths3d.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 12> length_;
  CommonScale length_scale;
};

Scaled scaled(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  Scaled s_;
  s_.length_ = odd_parts<12>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z});
  s_.length_scale.include<1>(s_.length_);
  return s_;
}

// The sign, if the inputs fit a lattice of that many bits.
template <int Bits>
Sign3 on_lattice(const Scaled& s_) {
  std::array<Bounded<Bits>, 12> length_;
  if (!put<1, Bits>(s_.length_scale, s_.length_, length_)) return Sign3::kUncertain;
  const auto ux = length_[3] - length_[0];
  const auto uy = length_[4] - length_[1];
  const auto uz = length_[5] - length_[2];
  const auto vx = length_[9] - length_[6];
  const auto vy = length_[10] - length_[7];
  const auto vz = length_[11] - length_[8];
  const auto det_ = formulas::compare_lengths3d_det(ux, uy, uz, vx, vy, vz);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 125 : 253));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 compare_lengths3d_lattice(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  const Scaled s_ = scaled(a, b, c, d);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign compare_lengths3d_exact(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  using T = Wide<degree_limbs(2, 5)>;
  return formulas::compare_lengths3d_of<T>(
      {wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 1>(a.z), wide<T, 1>(b.x), wide<T, 1>(b.y),
      wide<T, 1>(b.z), wide<T, 1>(c.x), wide<T, 1>(c.y), wide<T, 1>(c.z), wide<T, 1>(d.x),
      wide<T, 1>(d.y), wide<T, 1>(d.z)}).sign();
}

Sign3 compare_lengths3d_interval(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  const std::array<double, 12> v_ = {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z};
  std::array<Interval, 12> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::compare_lengths3d_of<Interval>(w_).sign();
}

Sign compare_lengths3d_after_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return compare_lengths3d_lattice(a, b, c, d); },
      [&] { return compare_lengths3d_interval(a, b, c, d); },
      [&] { return compare_lengths3d_exact(a, b, c, d); });
}

}  // namespace veritope::internal
