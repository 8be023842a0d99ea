// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/order_along_line2d.formula: do not edit.
// clang-format off
#include "predicates/generated/order_along_line2d.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 8> length_;
  CommonScale length_scale;
};

Scaled scaled(const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) {
  Scaled s_;
  s_.length_ = odd_parts<8>({a.x, a.y, b.x, b.y, p.x, p.y, q.x, q.y});
  s_.length_scale.include<1>(s_.length_);
  return s_;
}

// The sign, if the inputs fit a lattice of that many bits.
template <int Bits>
Sign3 on_lattice(const Scaled& s_) {
  std::array<Bounded<Bits>, 8> length_;
  if (!put<1, Bits>(s_.length_scale, s_.length_, length_)) return Sign3::kUncertain;
  const auto ux = length_[2] - length_[0];
  const auto uy = length_[3] - length_[1];
  const auto vx = length_[4] - length_[6];
  const auto vy = length_[5] - length_[7];
  const auto det_ = formulas::order_along_line2d_det(ux, uy, vx, vy);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 123 : 251));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 order_along_line2d_lattice(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) noexcept {
  const Scaled s_ = scaled(a, b, p, q);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign order_along_line2d_exact(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) noexcept {
  using T = Wide<degree_limbs(2, 3)>;
  return formulas::order_along_line2d_of<T>(
      {wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 1>(b.x), wide<T, 1>(b.y), wide<T, 1>(p.x),
      wide<T, 1>(p.y), wide<T, 1>(q.x), wide<T, 1>(q.y)}).sign();
}

Sign3 order_along_line2d_interval(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) noexcept {
  const std::array<double, 8> v_ = {a.x, a.y, b.x, b.y, p.x, p.y, q.x, q.y};
  std::array<Interval, 8> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::order_along_line2d_of<Interval>(w_).sign();
}

Sign order_along_line2d_after_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return order_along_line2d_lattice(a, b, p, q); },
      [&] { return order_along_line2d_interval(a, b, p, q); },
      [&] { return order_along_line2d_exact(a, b, p, q); });
}

}  // namespace veritope::internal
