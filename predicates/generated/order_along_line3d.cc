// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/order_along_line3d.formula: do not edit.
// clang-format off
#include "predicates/generated/order_along_line3d.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 12> length_;
  CommonScale length_scale;
};

Scaled scaled(const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) {
  Scaled s_;
  s_.length_ = odd_parts<12>({a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z, q.x, q.y, q.z});
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
  const auto vx = length_[6] - length_[9];
  const auto vy = length_[7] - length_[10];
  const auto vz = length_[8] - length_[11];
  const auto det_ = formulas::order_along_line3d_det(ux, uy, uz, vx, vy, vz);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 124 : 252));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 order_along_line3d_lattice(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) noexcept {
  const Scaled s_ = scaled(a, b, p, q);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign order_along_line3d_exact(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) noexcept {
  using T = Wide<degree_limbs(2, 4)>;
  return formulas::order_along_line3d_of<T>(
      {wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 1>(a.z), wide<T, 1>(b.x), wide<T, 1>(b.y),
      wide<T, 1>(b.z), wide<T, 1>(p.x), wide<T, 1>(p.y), wide<T, 1>(p.z), wide<T, 1>(q.x),
      wide<T, 1>(q.y), wide<T, 1>(q.z)}).sign();
}

Sign3 order_along_line3d_interval(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) noexcept {
  const std::array<double, 12> v_ = {a.x, a.y, a.z, b.x, b.y, b.z, p.x, p.y, p.z, q.x, q.y, q.z};
  std::array<Interval, 12> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::order_along_line3d_of<Interval>(w_).sign();
}

Sign order_along_line3d_after_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return order_along_line3d_lattice(a, b, p, q); },
      [&] { return order_along_line3d_interval(a, b, p, q); },
      [&] { return order_along_line3d_exact(a, b, p, q); });
}

}  // namespace veritope::internal
