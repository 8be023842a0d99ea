// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/compare_lengths3d.h: which of the segments ab and cd is longer?
// Made by tools/generate_predicates.py from predicates/generated/compare_lengths3d.formula: do not edit.
// Bound: docs/bounds/compare_lengths3d.md.
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

/// The exact sign of |b - a|^2 - |d - c|^2: positive iff ab is longer than cd, zero iff they are
/// equally long. Laws:
///   (1) swapping a and b does not change it;
///   (2) swapping a and c, b and d negates it;
///   (3) it does not change when a and b move by the same vector exactly;
///   (4) it does not change when c and d move by the same vector exactly;
///   (5) it does not change when all coordinates are scaled by one power of two.
/// Degenerate input: a segment of equal points has length zero.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 2 in binary64 where the filter decides
Sign compare_lengths3d(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
      TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (5u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/compare_lengths3d.md, and again in
///          tests/predicates/generated/compare_lengths3d_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 compare_lengths3d_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept;

namespace internal {
inline constexpr double kCompareLengths3dRel = 0x1.4000000000007p-51;

Sign3 compare_lengths3d_lattice(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept;
Sign3 compare_lengths3d_interval(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept;
Sign compare_lengths3d_exact(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept;
Sign compare_lengths3d_after_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto compare_lengths3d_det(
    const auto& ux, const auto& uy, const auto& uz, const auto& vx, const auto& vy,
    const auto& vz) {
  return ((sqr(ux) + sqr(uy)) + sqr(uz)) - ((sqr(vx) + sqr(vy)) + sqr(vz));
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto compare_lengths3d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& uz, const auto& vx,
    const auto& vy, const auto& vz) {
  return ((sqr(ux) + sqr(uy)) + sqr(uz)) + ((sqr(vx) + sqr(vy)) + sqr(vz));
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T compare_lengths3d_of(const std::array<T, 12>& v) {
  return compare_lengths3d_det(
      v[3] - v[0], v[4] - v[1], v[5] - v[2], v[9] - v[6], v[10] - v[7], v[11] - v[8]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double compare_lengths3d_error(
    FilterReal ux, FilterReal uy, FilterReal uz, FilterReal vx, FilterReal vy, FilterReal vz,
    double floor_) {
  const FilterReal magnitude_ = formulas::compare_lengths3d_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, ux, uy, uz, vx,
      vy, vz);
  return FilterReal(kCompareLengths3dRel) * magnitude_ + FilterReal(floor_);
}
}  // namespace internal

inline Sign3 compare_lengths3d_filter(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept {
  const FilterReal ux = FilterReal(b.x) - FilterReal(a.x);
  const FilterReal uy = FilterReal(b.y) - FilterReal(a.y);
  const FilterReal uz = FilterReal(b.z) - FilterReal(a.z);
  const FilterReal vx = FilterReal(d.x) - FilterReal(c.x);
  const FilterReal vy = FilterReal(d.y) - FilterReal(c.y);
  const FilterReal vz = FilterReal(d.z) - FilterReal(c.z);
  const FilterReal det_ = formulas::compare_lengths3d_det(ux, uy, uz, vx, vy, vz);
  return sign_beyond(det_, [&](double floor_) {
    return internal::compare_lengths3d_error(ux, uy, uz, vx, vy, vz, floor_);
  });
}

inline Sign compare_lengths3d(
      const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return compare_lengths3d_filter(a, b, c, d); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::compare_lengths3d_after_filter(a, b, c, d, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
