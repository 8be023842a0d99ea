// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/side_of_bisector2d.formula: do not edit.
// clang-format off
#include "predicates/generated/side_of_bisector2d.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 6> length_;
  CommonScale length_scale;
};

Scaled scaled(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  Scaled s_;
  s_.length_ = odd_parts<6>({a.x, a.y, b.x, b.y, p.x, p.y});
  s_.length_scale.include<1>(s_.length_);
  return s_;
}

// The sign, if the inputs fit a lattice of that many bits.
template <int Bits>
Sign3 on_lattice(const Scaled& s_) {
  std::array<Bounded<Bits>, 6> length_;
  if (!put<1, Bits>(s_.length_scale, s_.length_, length_)) return Sign3::kUncertain;
  const auto ux = length_[2] - length_[0];
  const auto uy = length_[3] - length_[1];
  const auto vx = length_[0] - length_[4];
  const auto vy = length_[1] - length_[5];
  const auto wx = length_[2] - length_[4];
  const auto wy = length_[3] - length_[5];
  const auto det_ = formulas::side_of_bisector2d_det(ux, uy, vx, vy, wx, wy);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 124 : 252));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 side_of_bisector2d_lattice(const Vec2d& a, const Vec2d& b, const Vec2d& p) noexcept {
  const Scaled s_ = scaled(a, b, p);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign side_of_bisector2d_exact(const Vec2d& a, const Vec2d& b, const Vec2d& p) noexcept {
  using T = Wide<degree_limbs(2, 4)>;
  return formulas::side_of_bisector2d_of<T>(
      {wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 1>(b.x), wide<T, 1>(b.y), wide<T, 1>(p.x),
      wide<T, 1>(p.y)}).sign();
}

Sign3 side_of_bisector2d_interval(const Vec2d& a, const Vec2d& b, const Vec2d& p) noexcept {
  const std::array<double, 6> v_ = {a.x, a.y, b.x, b.y, p.x, p.y};
  std::array<Interval, 6> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::side_of_bisector2d_of<Interval>(w_).sign();
}

Sign side_of_bisector2d_after_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return side_of_bisector2d_lattice(a, b, p); },
      [&] { return side_of_bisector2d_interval(a, b, p); },
      [&] { return side_of_bisector2d_exact(a, b, p); });
}

}  // namespace veritope::internal
