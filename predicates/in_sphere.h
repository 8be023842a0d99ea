// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/in_sphere.h: on which side of the sphere through a, b, c, d does e lie?
// Source: [She97] bound A, with terms for underflow.  Bound: docs/bounds/in_sphere.md.
#pragma once
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/filter.h"

namespace veritope {

/// The exact sign of the lifted determinant. If orient3d(a, b, c, d) > 0: positive iff e lies
/// inside the sphere through a, b, c, d, zero iff on it, negative iff outside. Laws:
///   (1) swapping two of the five points negates it;
///   (2) it does not change when all points move by the same vector exactly, or are scaled by one
///       power of two.
/// REQUIRES finite coordinates; all are allowed, the subnormal and the largest included.
Sign in_sphere(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, const Vec3d& e,
               TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (15u + O(u^2)) S + underflow, S <= 24 x y z (x^2 + y^2 + z^2) with the
///          largest difference on each axis, u = 2^-53.
/// Derived  docs/bounds/in_sphere.md, and again in tests/predicates/in_sphere_bound_test.cc.
/// Needs    round to nearest, gradual underflow, no contraction (robust/base/fp_guard.h).
Sign3 in_sphere_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                       const Vec3d& e) noexcept;

namespace internal {
inline constexpr double kInSphereRel = 0x1.680000000000fp-45;
inline constexpr double kInSphereEta = 0x1p-900;

Sign3 in_sphere_lattice(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                        const Vec3d& e) noexcept;
Sign3 in_sphere_interval(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                         const Vec3d& e) noexcept;
Sign in_sphere_exact(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                     const Vec3d& e) noexcept;
Sign in_sphere_after_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                            const Vec3d& e, TierCounts* tally) noexcept;
}  // namespace internal

// Bodies.

namespace internal {
/// x, y, z: no difference on an axis exceeds them.
inline double in_sphere_error(double x, double y, double z, double floor) {
  const formulas::InSphereBox<FilterReal> box(x, y, z);
  // S <= 24 M: 32 M overflows, and makes this infinite, before a part of det can.
  return (kInSphereRel * 0x1p-5) * ((0x1p5 * box.volume) * box.lift) +
         (kInSphereEta * box.size() + floor);
}
inline double largest_magnitude(double p, double q, double r, double s) {
  using veritope::larger;  // not the one of interval/bound_pair.h, which has integer comparisons
  return larger(larger(std::abs(p), std::abs(q)), larger(std::abs(r), std::abs(s)));
}
}  // namespace internal

inline Sign3 in_sphere_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                              const Vec3d& e) noexcept {
  const formulas::InSphere<FilterReal> f(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z,
                                         e.x, e.y, e.z);
  const auto largest = internal::largest_magnitude;
  const double x = largest(a.x - e.x, b.x - e.x, c.x - e.x, d.x - e.x),
               y = largest(a.y - e.y, b.y - e.y, c.y - e.y, d.y - e.y),
               z = largest(a.z - e.z, b.z - e.z, c.z - e.z, d.z - e.z);
  return sign_beyond(f.det(),
                     [&](double floor) { return internal::in_sphere_error(x, y, z, floor); });
}

inline Sign in_sphere(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                      const Vec3d& e, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return in_sphere_filter(a, b, c, d, e); },
      [&](TierCounts* t) VT_TIER { return internal::in_sphere_after_filter(a, b, c, d, e, t); });
}

}  // namespace veritope
