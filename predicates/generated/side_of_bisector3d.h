// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/side_of_bisector3d.h: on which side of the bisector of a and b does p lie?
// Made by tools/generate_predicates.py from predicates/generated/side_of_bisector3d.formula: do not edit.
// Bound: docs/bounds/side_of_bisector3d.md.
// clang-format off
#pragma once
#include <array>
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/generated/scaling.h"
#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/filter.h"

VT_PRECISE_BEGIN
namespace veritope {

/// The exact sign of |b - p|^2 - |a - p|^2: positive iff p lies on the side of a, zero iff on the
/// bisector; side_of_bisector3d(a, b, p) = -compare_distance3d(p, a, b), with the arguments in the
/// order of a side: the separating pair first, the point last. Laws:
///   (1) swapping a and b negates it;
///   (2) it does not change when all points move by the same vector exactly;
///   (3) it does not change when all coordinates are scaled by one power of two.
/// Degenerate input: a = b gives zero: there is no bisector.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 2 in binary64 where the filter decides
Sign side_of_bisector3d(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (5u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/side_of_bisector3d.md, and again in
///          tests/predicates/generated/side_of_bisector3d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 side_of_bisector3d_filter(const Vec3d& a, const Vec3d& b, const Vec3d& p) noexcept;

namespace internal {
inline constexpr double kSideOfBisector3dRel = 0x1.4000000000007p-51;

Sign3 side_of_bisector3d_lattice(const Vec3d& a, const Vec3d& b, const Vec3d& p) noexcept;
Sign3 side_of_bisector3d_interval(const Vec3d& a, const Vec3d& b, const Vec3d& p) noexcept;
Sign side_of_bisector3d_exact(const Vec3d& a, const Vec3d& b, const Vec3d& p) noexcept;
Sign side_of_bisector3d_after_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto side_of_bisector3d_det(
    const auto& ux, const auto& uy, const auto& uz, const auto& vx, const auto& vy, const auto& vz,
    const auto& wx, const auto& wy, const auto& wz) {
  const auto sumx = vx + wx;
  const auto sumy = vy + wy;
  const auto sumz = vz + wz;
  return (ux * sumx + uy * sumy) + uz * sumz;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto side_of_bisector3d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& uz, const auto& vx,
    const auto& vy, const auto& vz, const auto& wx, const auto& wy, const auto& wz) {
  const auto sumx_ = abs(vx) + abs(wx);
  const auto sumy_ = abs(vy) + abs(wy);
  const auto sumz_ = abs(vz) + abs(wz);
  return (abs(ux) * sumx_ + abs(uy) * sumy_) + abs(uz) * sumz_;
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T side_of_bisector3d_of(const std::array<T, 9>& v) {
  return side_of_bisector3d_det(
      v[3] - v[0], v[4] - v[1], v[5] - v[2], v[0] - v[6], v[1] - v[7], v[2] - v[8], v[3] - v[6],
      v[4] - v[7], v[5] - v[8]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double side_of_bisector3d_error(
    FilterReal ux, FilterReal uy, FilterReal uz, FilterReal vx, FilterReal vy, FilterReal vz,
    FilterReal wx, FilterReal wy, FilterReal wz, double floor_) {
  const FilterReal magnitude_ = formulas::side_of_bisector3d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, ux, uy, uz, vx,
      vy, vz, wx, wy, wz);
  return FilterReal(kSideOfBisector3dRel) * magnitude_ + FilterReal(floor_);
}
}  // namespace internal

inline Sign3 side_of_bisector3d_filter(const Vec3d& a, const Vec3d& b, const Vec3d& p) noexcept {
  const FilterReal ux = FilterReal(b.x) - FilterReal(a.x);
  const FilterReal uy = FilterReal(b.y) - FilterReal(a.y);
  const FilterReal uz = FilterReal(b.z) - FilterReal(a.z);
  const FilterReal vx = FilterReal(a.x) - FilterReal(p.x);
  const FilterReal vy = FilterReal(a.y) - FilterReal(p.y);
  const FilterReal vz = FilterReal(a.z) - FilterReal(p.z);
  const FilterReal wx = FilterReal(b.x) - FilterReal(p.x);
  const FilterReal wy = FilterReal(b.y) - FilterReal(p.y);
  const FilterReal wz = FilterReal(b.z) - FilterReal(p.z);
  const FilterReal det_ = formulas::side_of_bisector3d_det(ux, uy, uz, vx, vy, vz, wx, wy, wz);
  return sign_beyond(det_, [&](double floor_) {
    return internal::side_of_bisector3d_error(ux, uy, uz, vx, vy, vz, wx, wy, wz, floor_);
  });
}

inline Sign side_of_bisector3d(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return side_of_bisector3d_filter(a, b, p); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::side_of_bisector3d_after_filter(a, b, p, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
