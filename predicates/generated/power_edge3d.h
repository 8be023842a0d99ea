// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/power_edge3d.h: is the weighted point d in conflict with the smallest sphere that is orthogonal to those of a and b?
// Made by tools/generate_predicates.py from predicates/generated/power_edge3d.formula: do not edit.
// Source: [ES96].
// Bound: docs/bounds/power_edge3d.md.
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

/// The exact sign of |b - a|^2 times minus the power of d to the smallest of the spheres that are
/// orthogonal to those of a and b, its centre on the line ab; a weight is a squared radius, and may
/// be negative: positive iff d is in conflict with it, zero iff orthogonal. With equal weights:
/// positive iff d lies inside the sphere with the diameter ab. For collinear a, b, d it is the test
/// of regular triangulations on their line, whatever the order of a and b. Laws:
///   (1) swapping a and b, wa and wb does not change it;
///   (2) it does not change when all points move by the same vector exactly;
///   (3) it does not change when lengths are scaled by a power of two and weights by its square.
/// Degenerate input: a = b gives zero.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 4 in binary64 where the filter decides
Sign power_edge3d(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd,
      TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (11u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/power_edge3d.md, and again in
///          tests/predicates/generated/power_edge3d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 power_edge3d_filter(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) noexcept;

namespace internal {
inline constexpr double kPowerEdge3dRel = 0x1.600000000000ep-50;
inline constexpr double kPowerEdge3dEta = 0x1p-900;

Sign3 power_edge3d_lattice(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) noexcept;
Sign3 power_edge3d_interval(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) noexcept;
Sign power_edge3d_exact(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) noexcept;
Sign power_edge3d_after_filter(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd,
      TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto power_edge3d_det(
    const auto& px, const auto& py, const auto& pz, const auto& qx, const auto& qy, const auto& qz,
    const auto& ux, const auto& uy, const auto& uz, const auto& da, const auto& db) {
  return (da * ((qx * ux + qy * uy) + qz * uz) - db * ((px * ux + py * uy) + pz * uz))
      - ((px * qx + py * qy) + pz * qz) * ((sqr(ux) + sqr(uy)) + sqr(uz));
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto power_edge3d_magnitude(
    [[maybe_unused]] Abs abs, const auto& px, const auto& py, const auto& pz, const auto& qx,
    const auto& qy, const auto& qz, const auto& ux, const auto& uy, const auto& uz, const auto& da,
    const auto& db) {
  return (abs(da) * ((abs(qx * ux) + abs(qy * uy)) + abs(qz * uz)) +
      abs(db) * ((abs(px * ux) + abs(py * uy)) + abs(pz * uz))) + ((abs(px * qx) + abs(py * qy)) +
      abs(pz * qz)) * ((sqr(ux) + sqr(uy)) + sqr(uz));
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T power_edge3d_of(const std::array<T, 12>& v) {
  return power_edge3d_det(
      v[0] - v[8], v[1] - v[9], v[2] - v[10], v[4] - v[8], v[5] - v[9], v[6] - v[10], v[4] - v[0],
      v[5] - v[1], v[6] - v[2], v[11] - v[3], v[11] - v[7]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double power_edge3d_error(
    FilterReal px, FilterReal py, FilterReal pz, FilterReal qx, FilterReal qy, FilterReal qz,
    FilterReal ux, FilterReal uy, FilterReal uz, FilterReal da, FilterReal db, double floor_) {
  const FilterReal magnitude_ = formulas::power_edge3d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, px, py, pz, qx,
      qy, qz, ux, uy, uz, da, db);
  const FilterReal size_ = largest_of(px, py, pz, qx, qy, qz, ux, uy, uz, da, db);
  return FilterReal(kPowerEdge3dRel) * magnitude_ +
         (FilterReal(kPowerEdge3dEta) * power_of<2>(size_) + FilterReal(floor_));
}
}  // namespace internal

inline Sign3 power_edge3d_filter(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd) noexcept {
  const FilterReal px = FilterReal(a.x) - FilterReal(d.x);
  const FilterReal py = FilterReal(a.y) - FilterReal(d.y);
  const FilterReal pz = FilterReal(a.z) - FilterReal(d.z);
  const FilterReal qx = FilterReal(b.x) - FilterReal(d.x);
  const FilterReal qy = FilterReal(b.y) - FilterReal(d.y);
  const FilterReal qz = FilterReal(b.z) - FilterReal(d.z);
  const FilterReal ux = FilterReal(b.x) - FilterReal(a.x);
  const FilterReal uy = FilterReal(b.y) - FilterReal(a.y);
  const FilterReal uz = FilterReal(b.z) - FilterReal(a.z);
  const FilterReal da = FilterReal(wd) - FilterReal(wa);
  const FilterReal db = FilterReal(wd) - FilterReal(wb);
  const FilterReal det_ = formulas::power_edge3d_det(px, py, pz, qx, qy, qz, ux, uy, uz, da, db);
  return sign_beyond(det_, [&](double floor_) {
    return internal::power_edge3d_error(px, py, pz, qx, qy, qz, ux, uy, uz, da, db, floor_);
  });
}

inline Sign power_edge3d(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& d, double wd,
      TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return power_edge3d_filter(a, wa, b, wb, d, wd); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::power_edge3d_after_filter(a, wa, b, wb, d, wd, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
