// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/orient3d.h: on which side of the plane through a, b, c does d lie?
// Source: [She97] bound A, with terms for underflow.  Bound: docs/bounds/orient3d.md.
#pragma once
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/filter.h"

namespace veritope {

/// The exact sign of det(b - a, c - a, d - a), six times the signed volume of a, b, c, d: positive
/// iff a, b, c turn counter-clockwise as seen from d, orient3d(0, e1, e2, e3) = +1; zero iff they
/// lie on one plane. Laws:
///   (1) swapping two points negates it;
///   (2) it does not change when all points move by the same vector exactly, nor when one axis is
///       scaled by a power of two.
/// REQUIRES finite coordinates; all are allowed, the subnormal and the largest included.
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
              TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (7u + O(u^2)) S + underflow, S = the sum of the absolute terms, u =
///          2^-53.
/// Derived  docs/bounds/orient3d.md, and again in tests/predicates/orient3d_bound_test.cc.
/// Needs    round to nearest, gradual underflow, no contraction (robust/base/fp_guard.h).
Sign3 orient3d_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept;

/// The filter above, bit for bit, for one plane and many points d: the products of a, b, c are kept.
class Orient3dPlaneFilter {
 public:
  Orient3dPlaneFilter(const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept;
  Sign3 operator()(const Vec3d& d) const noexcept;

 private:
  formulas::Plane3<FilterReal> plane_;
};

namespace internal {
inline constexpr double kOrient3dRel = 0x1.c00000000000dp-51;
inline constexpr double kOrient3dEta = 0x1p-900;

Sign3 orient3d_lattice(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept;
Sign3 orient3d_interval(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept;
Sign orient3d_exact(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) noexcept;
Sign orient3d_after_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                           TierCounts* tally) noexcept;
}  // namespace internal

// Bodies.

inline Orient3dPlaneFilter::Orient3dPlaneFilter(const Vec3d& a, const Vec3d& b,
                                                const Vec3d& c) noexcept
    : plane_(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z) {}

namespace internal {
inline double orient3d_error(const formulas::Plane3<FilterReal>& plane, double wx, double wy,
                             double wz, double floor) {
  const auto abs = [](double v) { return std::abs(v); };
  return kOrient3dRel * plane.magnitude(wx, wy, wz, abs) +
         (kOrient3dEta * plane.size(wx, wy, wz, abs) + floor);
}
}  // namespace internal

inline Sign3 Orient3dPlaneFilter::operator()(const Vec3d& d) const noexcept {
  const double wx = d.x - plane_.ax, wy = d.y - plane_.ay, wz = d.z - plane_.az;
  return sign_beyond(plane_.det(wx, wy, wz), [&](double floor) {
    return internal::orient3d_error(plane_, wx, wy, wz, floor);
  });
}

inline Sign3 orient3d_filter(const Vec3d& a, const Vec3d& b, const Vec3d& c,
                             const Vec3d& d) noexcept {
  return Orient3dPlaneFilter(a, b, c)(d);
}

inline Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                     TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return orient3d_filter(a, b, c, d); },
      [&](TierCounts* t) VT_TIER { return internal::orient3d_after_filter(a, b, c, d, t); });
}

}  // namespace veritope
