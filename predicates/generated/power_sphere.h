// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/power_sphere.h: is the weighted point e in conflict with the sphere that is orthogonal to those of a, b, c, d?
// Made by tools/generate_predicates.py from predicates/generated/power_sphere.formula: do not edit.
// Source: [ES96].
// Bound: docs/bounds/power_sphere.md.
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

/// The exact sign of the lifted determinant, with |p|^2 - w in the place of |p|^2; a weight is a
/// squared radius, and may be negative. If orient3d(a, b, c, d) > 0: positive iff the power of e to
/// the sphere that is orthogonal to a, b, c, d is negative, so that e belongs into the
/// triangulation in the place of the tetrahedron, zero iff e's sphere is orthogonal, too. With
/// equal weights it is in_sphere. Laws:
///   (1) swapping a and b, wa and wb negates it;
///   (2) swapping b and c, wb and wc negates it;
///   (3) swapping c and d, wc and wd negates it;
///   (4) swapping d and e, wd and we negates it;
///   (5) it does not change when all points move by the same vector exactly;
///   (6) it does not change when lengths are scaled by a power of two and weights by its square.
/// Degenerate input: zero for two equal points with equal weights; if a, b, c, d are coplanar, the
/// sign orders them and e over the lifted plane.
/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.
/// @cost a polynomial of degree 5 in binary64 where the filter decides
Sign power_sphere(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we, TierCounts* tally = nullptr) noexcept;

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
/// Bound    |det - exact| <= (16u + O(u^2)) S + underflow, S = the sum of the absolute terms, of
///          the largest difference on each axis, u = 2^-53.
/// Derived  docs/bounds/power_sphere.md, and again in
///          tests/predicates/generated/power_sphere_test.cc.
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
Sign3 power_sphere_filter(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) noexcept;

namespace internal {
inline constexpr double kPowerSphereRel = 0x1.000000000000ep-49;
inline constexpr double kPowerSphereEta = 0x1p-900;

Sign3 power_sphere_lattice(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) noexcept;
Sign3 power_sphere_interval(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) noexcept;
Sign power_sphere_exact(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) noexcept;
Sign power_sphere_after_filter(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we, TierCounts* tally) noexcept;
}  // namespace internal

namespace formulas {
/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto power_sphere_det(
    const auto& px, const auto& py, const auto& pz, const auto& qx, const auto& qy, const auto& qz,
    const auto& rx, const auto& ry, const auto& rz, const auto& sx, const auto& sy, const auto& sz,
    const auto& pw, const auto& qw, const auto& rw, const auto& sw) {
  const auto pq = px * qy - qx * py;
  const auto qr = qx * ry - rx * qy;
  const auto rs = rx * sy - sx * ry;
  const auto sp = sx * py - px * sy;
  const auto pr = px * ry - rx * py;
  const auto qs = qx * sy - sx * qy;
  const auto pqr = (pz * qr - qz * pr) + rz * pq;
  const auto qrs = (qz * rs - rz * qs) + sz * qr;
  const auto rsp = (rz * sp + sz * pr) + pz * rs;
  const auto spq = (sz * pq + pz * qs) + qz * sp;
  const auto p_lift = ((sqr(px) + sqr(py)) + sqr(pz)) - pw;
  const auto q_lift = ((sqr(qx) + sqr(qy)) + sqr(qz)) - qw;
  const auto r_lift = ((sqr(rx) + sqr(ry)) + sqr(rz)) - rw;
  const auto s_lift = ((sqr(sx) + sqr(sy)) + sqr(sz)) - sw;
  return (p_lift * qrs - q_lift * rsp) + (r_lift * spq - s_lift * pqr);
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto power_sphere_magnitude(
    [[maybe_unused]] Abs abs, const auto& px, const auto& py, const auto& pz, const auto& qx,
    const auto& qy, const auto& qz, const auto& rx, const auto& ry, const auto& rz, const auto& sx,
    const auto& sy, const auto& sz, const auto& pw, const auto& qw, const auto& rw,
    const auto& sw) {
  const auto pq_ = abs(px * qy) + abs(qx * py);
  const auto qr_ = abs(qx * ry) + abs(rx * qy);
  const auto rs_ = abs(rx * sy) + abs(sx * ry);
  const auto sp_ = abs(sx * py) + abs(px * sy);
  const auto pr_ = abs(px * ry) + abs(rx * py);
  const auto qs_ = abs(qx * sy) + abs(sx * qy);
  const auto pqr_ = (abs(pz) * qr_ + abs(qz) * pr_) + abs(rz) * pq_;
  const auto qrs_ = (abs(qz) * rs_ + abs(rz) * qs_) + abs(sz) * qr_;
  const auto rsp_ = (abs(rz) * sp_ + abs(sz) * pr_) + abs(pz) * rs_;
  const auto spq_ = (abs(sz) * pq_ + abs(pz) * qs_) + abs(qz) * sp_;
  const auto p_lift_ = ((sqr(px) + sqr(py)) + sqr(pz)) + abs(pw);
  const auto q_lift_ = ((sqr(qx) + sqr(qy)) + sqr(qz)) + abs(qw);
  const auto r_lift_ = ((sqr(rx) + sqr(ry)) + sqr(rz)) + abs(rw);
  const auto s_lift_ = ((sqr(sx) + sqr(sy)) + sqr(sz)) + abs(sw);
  return (p_lift_ * qrs_ + q_lift_ * rsp_) + (r_lift_ * spq_ + s_lift_ * pqr_);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T power_sphere_of(const std::array<T, 20>& v) {
  return power_sphere_det(
      v[0] - v[16], v[1] - v[17], v[2] - v[18], v[4] - v[16], v[5] - v[17], v[6] - v[18],
      v[8] - v[16], v[9] - v[17], v[10] - v[18], v[12] - v[16], v[13] - v[17], v[14] - v[18],
      v[3] - v[19], v[7] - v[19], v[11] - v[19], v[15] - v[19]);
}
}  // namespace formulas

// Bodies.

namespace internal {
inline double power_sphere_error(
    FilterReal px, FilterReal py, FilterReal pz, FilterReal qx, FilterReal qy, FilterReal qz,
    FilterReal rx, FilterReal ry, FilterReal rz, FilterReal sx, FilterReal sy, FilterReal sz,
    FilterReal pw, FilterReal qw, FilterReal rw, FilterReal sw, double floor_) {
  const FilterReal largest_x_ = largest_of(px, qx, rx, sx);
  const FilterReal largest_y_ = largest_of(py, qy, ry, sy);
  const FilterReal largest_z_ = largest_of(pz, qz, rz, sz);
  const FilterReal largest_number_ = largest_of(pw, qw, rw, sw);
  const FilterReal magnitude_ = formulas::power_sphere_magnitude(
      [](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }, largest_x_,
      largest_y_, largest_z_, largest_x_, largest_y_, largest_z_, largest_x_, largest_y_,
      largest_z_, largest_x_, largest_y_, largest_z_, largest_number_, largest_number_,
      largest_number_, largest_number_);
  const FilterReal size_ = largest_of(largest_x_, largest_y_, largest_z_, largest_number_);
  return FilterReal(kPowerSphereRel) * magnitude_ +
         (FilterReal(kPowerSphereEta) * power_of<3>(size_) + FilterReal(floor_));
}
}  // namespace internal

inline Sign3 power_sphere_filter(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we) noexcept {
  const FilterReal px = FilterReal(a.x) - FilterReal(e.x);
  const FilterReal py = FilterReal(a.y) - FilterReal(e.y);
  const FilterReal pz = FilterReal(a.z) - FilterReal(e.z);
  const FilterReal qx = FilterReal(b.x) - FilterReal(e.x);
  const FilterReal qy = FilterReal(b.y) - FilterReal(e.y);
  const FilterReal qz = FilterReal(b.z) - FilterReal(e.z);
  const FilterReal rx = FilterReal(c.x) - FilterReal(e.x);
  const FilterReal ry = FilterReal(c.y) - FilterReal(e.y);
  const FilterReal rz = FilterReal(c.z) - FilterReal(e.z);
  const FilterReal sx = FilterReal(d.x) - FilterReal(e.x);
  const FilterReal sy = FilterReal(d.y) - FilterReal(e.y);
  const FilterReal sz = FilterReal(d.z) - FilterReal(e.z);
  const FilterReal pw = FilterReal(wa) - FilterReal(we);
  const FilterReal qw = FilterReal(wb) - FilterReal(we);
  const FilterReal rw = FilterReal(wc) - FilterReal(we);
  const FilterReal sw = FilterReal(wd) - FilterReal(we);
  const FilterReal det_ = formulas::power_sphere_det(
      px, py, pz, qx, qy, qz, rx, ry, rz, sx, sy, sz, pw, qw, rw, sw);
  return sign_beyond(det_, [&](double floor_) {
    return internal::power_sphere_error(
        px, py, pz, qx, qy, qz, rx, ry, rz, sx, sy, sz, pw, qw, rw, sw, floor_);
  });
}

inline Sign power_sphere(
      const Vec3d& a, double wa, const Vec3d& b, double wb, const Vec3d& c, double wc,
      const Vec3d& d, double wd, const Vec3d& e, double we, TierCounts* tally) noexcept {
  return cascade(
      tally, [&]() VT_TIER { return power_sphere_filter(a, wa, b, wb, c, wc, d, wd, e, we); },
      [&](TierCounts* rest_)
          VT_TIER { return internal::power_sphere_after_filter(a, wa, b, wb, c, wc, d, wd, e, we, rest_); });
}

}  // namespace veritope
VT_PRECISE_END
