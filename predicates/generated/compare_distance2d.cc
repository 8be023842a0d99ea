// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/compare_distance2d.formula: do not edit.
// clang-format off
#include "predicates/generated/compare_distance2d.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 6> length_;
  CommonScale length_scale;
};

Scaled scaled(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  Scaled s_;
  s_.length_ = odd_parts<6>({p.x, p.y, a.x, a.y, b.x, b.y});
  s_.length_scale.include<1>(s_.length_);
  return s_;
}

// The sign, if the inputs fit a lattice of that many bits.
template <int Bits>
Sign3 on_lattice(const Scaled& s_) {
  std::array<Bounded<Bits>, 6> length_;
  if (!put<1, Bits>(s_.length_scale, s_.length_, length_)) return Sign3::kUncertain;
  const auto ux = length_[2] - length_[4];
  const auto uy = length_[3] - length_[5];
  const auto vx = length_[2] - length_[0];
  const auto vy = length_[3] - length_[1];
  const auto wx = length_[4] - length_[0];
  const auto wy = length_[5] - length_[1];
  const auto det_ = formulas::compare_distance2d_det(ux, uy, vx, vy, wx, wy);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 124 : 252));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 compare_distance2d_lattice(const Vec2d& p, const Vec2d& a, const Vec2d& b) noexcept {
  const Scaled s_ = scaled(p, a, b);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign compare_distance2d_exact(const Vec2d& p, const Vec2d& a, const Vec2d& b) noexcept {
  using T = Wide<degree_limbs(2, 4)>;
  return formulas::compare_distance2d_of<T>(
      {wide<T, 1>(p.x), wide<T, 1>(p.y), wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 1>(b.x),
      wide<T, 1>(b.y)}).sign();
}

Sign3 compare_distance2d_interval(const Vec2d& p, const Vec2d& a, const Vec2d& b) noexcept {
  const std::array<double, 6> v_ = {p.x, p.y, a.x, a.y, b.x, b.y};
  std::array<Interval, 6> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::compare_distance2d_of<Interval>(w_).sign();
}

Sign compare_distance2d_after_filter(
      const Vec2d& p, const Vec2d& a, const Vec2d& b, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return compare_distance2d_lattice(p, a, b); },
      [&] { return compare_distance2d_interval(p, a, b); },
      [&] { return compare_distance2d_exact(p, a, b); });
}

}  // namespace veritope::internal
