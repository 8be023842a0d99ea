// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/power_circle.formula: do not edit.
// clang-format off
#include "predicates/generated/power_circle.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 8> length_;
  std::array<Binary64, 4> length_2_;
  CommonScale length_scale;
};

Scaled scaled(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) {
  Scaled s_;
  s_.length_ = odd_parts<8>({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
  s_.length_2_ = odd_parts<4>({wa, wb, wc, wd});
  s_.length_scale.include<1>(s_.length_);
  s_.length_scale.include<2>(s_.length_2_);
  return s_;
}

// The sign, if the inputs fit a lattice of that many bits.
template <int Bits>
Sign3 on_lattice(const Scaled& s_) {
  std::array<Bounded<Bits>, 8> length_;
  std::array<Bounded<2 * Bits>, 4> length_2_;
  if (!put<1, Bits>(s_.length_scale, s_.length_, length_)) return Sign3::kUncertain;
  if (!put<2, Bits>(s_.length_scale, s_.length_2_, length_2_)) return Sign3::kUncertain;
  const auto px = length_[0] - length_[6];
  const auto py = length_[1] - length_[7];
  const auto qx = length_[2] - length_[6];
  const auto qy = length_[3] - length_[7];
  const auto rx = length_[4] - length_[6];
  const auto ry = length_[5] - length_[7];
  const auto pw = length_2_[0] - length_2_[3];
  const auto qw = length_2_[1] - length_2_[3];
  const auto rw = length_2_[2] - length_2_[3];
  if constexpr (Bits == kOneLimbBits) {
    if (fits<30>(px) &&
        fits<30>(py) &&
        fits<30>(qx) &&
        fits<30>(qy) &&
        fits<30>(rx) &&
        fits<30>(ry) &&
        fits<60>(pw) &&
        fits<60>(qw) &&
        fits<60>(rw)) {
      const auto det_ = formulas::power_circle_det(
          narrowed<30>(px), narrowed<30>(py), narrowed<30>(qx), narrowed<30>(qy), narrowed<30>(rx),
          narrowed<30>(ry), narrowed<60>(pw), narrowed<60>(qw), narrowed<60>(rw));
      static_assert(decltype(det_)::kBits == 125);
      return to_sign3(sign_of(det_));
    }
  }
  const auto det_ = formulas::power_circle_det(px, py, qx, qy, rx, ry, pw, qw, rw);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 248 : 504));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 power_circle_lattice(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) noexcept {
  const Scaled s_ = scaled(a, wa, b, wb, c, wc, d, wd);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign power_circle_exact(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) noexcept {
  using T = Wide<degree_limbs(4, 8)>;
  return formulas::power_circle_of<T>(
      {wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 2>(wa), wide<T, 1>(b.x), wide<T, 1>(b.y),
      wide<T, 2>(wb), wide<T, 1>(c.x), wide<T, 1>(c.y), wide<T, 2>(wc), wide<T, 1>(d.x),
      wide<T, 1>(d.y), wide<T, 2>(wd)}).sign();
}

Sign3 power_circle_interval(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd) noexcept {
  const std::array<double, 12> v_ = {a.x, a.y, wa, b.x, b.y, wb, c.x, c.y, wc, d.x, d.y, wd};
  std::array<Interval, 12> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::power_circle_of<Interval>(w_).sign();
}

Sign power_circle_after_filter(
      const Vec2d& a, double wa, const Vec2d& b, double wb, const Vec2d& c, double wc,
      const Vec2d& d, double wd, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return power_circle_lattice(a, wa, b, wb, c, wc, d, wd); },
      [&] { return power_circle_interval(a, wa, b, wb, c, wc, d, wd); },
      [&] { return power_circle_exact(a, wa, b, wb, c, wc, d, wd); });
}

}  // namespace veritope::internal
