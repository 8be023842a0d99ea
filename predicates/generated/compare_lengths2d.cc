// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/compare_lengths2d.formula: do not edit.
// clang-format off
#include "predicates/generated/compare_lengths2d.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 8> length_;
  CommonScale length_scale;
};

Scaled scaled(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  Scaled s_;
  s_.length_ = odd_parts<8>({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
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
  const auto vx = length_[6] - length_[4];
  const auto vy = length_[7] - length_[5];
  const auto det_ = formulas::compare_lengths2d_det(ux, uy, vx, vy);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 124 : 252));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 compare_lengths2d_lattice(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept {
  const Scaled s_ = scaled(a, b, c, d);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign compare_lengths2d_exact(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept {
  using T = Wide<degree_limbs(2, 4)>;
  return formulas::compare_lengths2d_of<T>(
      {wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 1>(b.x), wide<T, 1>(b.y), wide<T, 1>(c.x),
      wide<T, 1>(c.y), wide<T, 1>(d.x), wide<T, 1>(d.y)}).sign();
}

Sign3 compare_lengths2d_interval(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept {
  const std::array<double, 8> v_ = {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
  std::array<Interval, 8> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::compare_lengths2d_of<Interval>(w_).sign();
}

Sign compare_lengths2d_after_filter(
      const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return compare_lengths2d_lattice(a, b, c, d); },
      [&] { return compare_lengths2d_interval(a, b, c, d); },
      [&] { return compare_lengths2d_exact(a, b, c, d); });
}

}  // namespace veritope::internal
