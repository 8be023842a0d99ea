// SPDX-License-Identifier: LGPL-3.0-or-later
// Made by tools/generate_predicates.py from predicates/generated/power_sphere.formula: do not edit.
// clang-format off
#include "predicates/generated/power_sphere.h"

#include "interval/interval.h"

namespace veritope::internal {
namespace {

// Each scale of the inputs has a power of two of its own.
struct Scaled {
  std::array<Binary64, 15> length_;
  std::array<Binary64, 5> length_2_;
  CommonScale length_scale;
};

Scaled scaled(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) {
  Scaled s_;
  s_.length_ = odd_parts<15>(
      {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z});
  s_.length_2_ = odd_parts<5>({wa, wb, wc, wd, we});
  s_.length_scale.include<1>(s_.length_);
  s_.length_scale.include<2>(s_.length_2_);
  return s_;
}

// The sign, if the inputs fit a lattice of that many bits.
template <int Bits>
Sign3 on_lattice(const Scaled& s_) {
  std::array<Bounded<Bits>, 15> length_;
  std::array<Bounded<2 * Bits>, 5> length_2_;
  if (!put<1, Bits>(s_.length_scale, s_.length_, length_)) return Sign3::kUncertain;
  if (!put<2, Bits>(s_.length_scale, s_.length_2_, length_2_)) return Sign3::kUncertain;
  const auto px = length_[0] - length_[12];
  const auto py = length_[1] - length_[13];
  const auto pz = length_[2] - length_[14];
  const auto qx = length_[3] - length_[12];
  const auto qy = length_[4] - length_[13];
  const auto qz = length_[5] - length_[14];
  const auto rx = length_[6] - length_[12];
  const auto ry = length_[7] - length_[13];
  const auto rz = length_[8] - length_[14];
  const auto sx = length_[9] - length_[12];
  const auto sy = length_[10] - length_[13];
  const auto sz = length_[11] - length_[14];
  const auto pw = length_2_[0] - length_2_[4];
  const auto qw = length_2_[1] - length_2_[4];
  const auto rw = length_2_[2] - length_2_[4];
  const auto sw = length_2_[3] - length_2_[4];
  if constexpr (Bits == kOneLimbBits) {
    if (fits<23>(px) &&
        fits<23>(py) &&
        fits<23>(pz) &&
        fits<23>(qx) &&
        fits<23>(qy) &&
        fits<23>(qz) &&
        fits<23>(rx) &&
        fits<23>(ry) &&
        fits<23>(rz) &&
        fits<23>(sx) &&
        fits<23>(sy) &&
        fits<23>(sz) &&
        fits<46>(pw) &&
        fits<46>(qw) &&
        fits<46>(rw) &&
        fits<46>(sw)) {
      const auto det_ = formulas::power_sphere_det(
          narrowed<23>(px), narrowed<23>(py), narrowed<23>(pz), narrowed<23>(qx), narrowed<23>(qy),
          narrowed<23>(qz), narrowed<23>(rx), narrowed<23>(ry), narrowed<23>(rz), narrowed<23>(sx),
          narrowed<23>(sy), narrowed<23>(sz), narrowed<46>(pw), narrowed<46>(qw), narrowed<46>(rw),
          narrowed<46>(sw));
      static_assert(decltype(det_)::kBits == 122);
      return to_sign3(sign_of(det_));
    }
  }
  const auto det_ = formulas::power_sphere_det(
      px, py, pz, qx, qy, qz, rx, ry, rz, sx, sy, sz, pw, qw, rw, sw);
  static_assert(decltype(det_)::kBits ==
                (Bits == kOneLimbBits ? 312 : 632));
  return to_sign3(sign_of(det_));
}

}  // namespace

Sign3 power_sphere_lattice(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) noexcept {
  const Scaled s_ = scaled(a, wa, b, wb, c, wc, d, wd, e, we);
  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);
  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);
}

Sign power_sphere_exact(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) noexcept {
  using T = Wide<degree_limbs(5, 12)>;
  return formulas::power_sphere_of<T>(
      {wide<T, 1>(a.x), wide<T, 1>(a.y), wide<T, 1>(a.z), wide<T, 2>(wa), wide<T, 1>(b.x),
      wide<T, 1>(b.y), wide<T, 1>(b.z), wide<T, 2>(wb), wide<T, 1>(c.x), wide<T, 1>(c.y),
      wide<T, 1>(c.z), wide<T, 2>(wc), wide<T, 1>(d.x), wide<T, 1>(d.y), wide<T, 1>(d.z),
      wide<T, 2>(wd), wide<T, 1>(e.x), wide<T, 1>(e.y), wide<T, 1>(e.z), wide<T, 2>(we)}).sign();
}

Sign3 power_sphere_interval(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) noexcept {
  const std::array<double, 20> v_ = {
      a.x, a.y, a.z, wa, b.x, b.y, b.z, wb, c.x, c.y, c.z, wc, d.x, d.y, d.z, wd, e.x, e.y, e.z,
      we};
  std::array<Interval, 20> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::power_sphere_of<Interval>(w_).sign();
}

Sign power_sphere_after_filter(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we, TierCounts* tally) noexcept {
  return cascade<1>(
      tally, [&] { return power_sphere_lattice(a, wa, b, wb, c, wc, d, wd, e, we); },
      [&] { return power_sphere_interval(a, wa, b, wb, c, wc, d, wd, e, we); },
      [&] { return power_sphere_exact(a, wa, b, wb, c, wc, d, wd, e, we); });
}

}  // namespace veritope::internal
