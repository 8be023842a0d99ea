// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/order_along_line3d.h: which of p and q comes later along the line from a to b?
// Made by tools/generate_predicates.py from predicates/generated/order_along_line3d.formula: do not edit.
// Bound: docs/bounds/order_along_line3d.md.
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

/// The exact sign of (b - a) . (p - q): positive iff p comes after q in the direction from a to b,
/// zero iff the line's normal plane through p contains q. The points need not lie on the line:
/// their projections are compared. Laws:
///   (1) swapping p and q negates it;
///   (2) swapping a and b negates it;
///   (3) it does not change when a and b move by the same vector exactly;
///   (4) it does not change when p and q move by the same vector exactly;
///   (5) it does not change when all coordinates are scaled by one power of two.
/// Degenerate input: a = b gives zero.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 2 in binary64 where the filter decides
Sign order_along_line3d(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q,
      TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (4u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/order_along_line3d.md, and again in
///          tests/predicates/generated/order_along_line3d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 order_along_line3d_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) noexcept;

namespace internal {
inline constexpr double kOrderAlongLine3dRel = 0x1.0000000000005p-51;

Sign3 order_along_line3d_lattice(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) noexcept;
Sign3 order_along_line3d_interval(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) noexcept;
Sign order_along_line3d_exact(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) noexcept;
Sign order_along_line3d_after_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto order_along_line3d_det(
    const auto& ux, const auto& uy, const auto& uz, const auto& vx, const auto& vy,
    const auto& vz) {
  return (ux * vx + uy * vy) + uz * vz;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto order_along_line3d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& uz, const auto& vx,
    const auto& vy, const auto& vz) {
  return (abs(ux * vx) + abs(uy * vy)) + abs(uz * vz);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T order_along_line3d_of(const std::array<T, 12>& v) {
  return order_along_line3d_det(
      v[3] - v[0], v[4] - v[1], v[5] - v[2], v[6] - v[9], v[7] - v[10], v[8] - v[11]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double order_along_line3d_error(
    FilterReal ux, FilterReal uy, FilterReal uz, FilterReal vx, FilterReal vy, FilterReal vz,
    double floor_) {
  const FilterReal magnitude_ = formulas::order_along_line3d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, ux, uy, uz, vx,
      vy, vz);
  return FilterReal(kOrderAlongLine3dRel) * magnitude_ + FilterReal(floor_);
}
}  // namespace internal

inline Sign3 order_along_line3d_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q) noexcept {
  const FilterReal ux = FilterReal(b.x) - FilterReal(a.x);
  const FilterReal uy = FilterReal(b.y) - FilterReal(a.y);
  const FilterReal uz = FilterReal(b.z) - FilterReal(a.z);
  const FilterReal vx = FilterReal(p.x) - FilterReal(q.x);
  const FilterReal vy = FilterReal(p.y) - FilterReal(q.y);
  const FilterReal vz = FilterReal(p.z) - FilterReal(q.z);
  const FilterReal det_ = formulas::order_along_line3d_det(ux, uy, uz, vx, vy, vz);
  return sign_beyond(det_, [&](double floor_) {
    return internal::order_along_line3d_error(ux, uy, uz, vx, vy, vz, floor_);
  });
}

inline Sign order_along_line3d(
      const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& q, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return order_along_line3d_filter(a, b, p, q); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::order_along_line3d_after_filter(a, b, p, q, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
