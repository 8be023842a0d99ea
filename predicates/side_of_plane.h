// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/side_of_plane.h: on which side of a plane given by its coefficients does a point lie?
// Bound: docs/bounds/side_of_plane.md.
#pragma once
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/filter.h"

namespace veritope {

/// { p : normal . p + offset = 0 }. The zero normal is allowed: then the sign is that of offset
/// everywhere.
struct PlaneCoefficients {
  Vec3d normal;
  double offset = 0;
};

/// The exact sign of normal . p + offset; positive on the side that the normal points to. Negating
/// all coefficients negates it.
/// REQUIRES finite numbers; all are allowed.
Sign side_of_plane(const PlaneCoefficients& plane, const Vec3d& p,
                   TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (3u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/side_of_plane.md, and again in
///          tests/predicates/side_of_plane_bound_test.cc.
/// Needs    round to nearest, gradual underflow, no contraction (robust/base/fp_guard.h).
Sign3 side_of_plane_filter(const PlaneCoefficients& plane, const Vec3d& p) noexcept;

namespace internal {
inline constexpr double kSideOfPlaneRel = 0x1.8000000000007p-52;

Sign3 side_of_plane_lattice(const PlaneCoefficients& plane, const Vec3d& p) noexcept;
Sign3 side_of_plane_interval(const PlaneCoefficients& plane, const Vec3d& p) noexcept;
Sign side_of_plane_exact(const PlaneCoefficients& plane, const Vec3d& p) noexcept;
Sign side_of_plane_after_filter(const PlaneCoefficients& plane, const Vec3d& p,
                                TierCounts* tally) noexcept;
}  // namespace internal

// Bodies.

inline Sign3 side_of_plane_filter(const PlaneCoefficients& plane, const Vec3d& p) noexcept {
  const formulas::SideOfPlane<FilterReal> f(plane.normal.x, plane.normal.y, plane.normal.z,
                                            plane.offset, p.x, p.y, p.z);
  const double size = f.magnitude([](double v) { return std::abs(v); });
  return sign_beyond(f.det(), internal::kSideOfPlaneRel * size);
}

inline Sign side_of_plane(const PlaneCoefficients& plane, const Vec3d& p,
                          TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return side_of_plane_filter(plane, p); },
      [&](TierCounts* t) VT_TIER { return internal::side_of_plane_after_filter(plane, p, t); });
}

}  // namespace veritope
