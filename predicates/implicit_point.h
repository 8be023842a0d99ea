// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/implicit_point.h: points that doubles cannot hold, given by explicit ones: where a line meets a plane,
// where three planes meet. Decisions about them are exact; nothing is rounded.
// Source: [Att20], LPI and TPI.  Bound: docs/bounds/implicit_point.md.
#pragma once
#include <array>

#include "predicates/vec.h"
#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"

namespace veritope {

namespace internal {
/// What the filter needs: base + (x, y, z) / d, rounded, with two scalars that bound the errors. If d > 0, so is the
/// exact denominator, or both were negated; if d = 0, the filter does not know the point.
struct ImplicitLayer {
  double x = 0, y = 0, z = 0, d = 0;
  double scale = 0, reach = 0;
};
}  // namespace internal

/// The point of the line through p and q on the plane through a, b, c. Immutable.
class LinePlanePoint {
 public:
  /// REQUIRES finite coordinates. Takes approximately 10 ns.
  LinePlanePoint(const Vec3d& p, const Vec3d& q, const Vec3d& a, const Vec3d& b,
                 const Vec3d& c) noexcept;

  /// Is there exactly one such point? Not if p = q, if a, b, c lie on a line, or if line and plane are
  /// parallel. Exact.
  bool is_defined() const noexcept { return denominator_ != Sign::kZero; }
  /// p, q, a, b, c
  const std::array<Vec3d, 5>& points() const { return points_; }
  const internal::ImplicitLayer& layer() const { return layer_; }
  /// The sign of (b - a) x (c - a) . (q - p).
  Sign denominator_sign() const { return denominator_; }

 private:
  std::array<Vec3d, 5> points_;
  internal::ImplicitLayer layer_;
  Sign denominator_;
};

/// The point on three planes, each through three points. Immutable.
class ThreePlanePoint {
 public:
  /// points: three of the first plane, three of the second, three of the third. REQUIRES finite
  /// coordinates. Takes approximately 35 ns.
  explicit ThreePlanePoint(const std::array<Vec3d, 9>& points) noexcept;

  /// Is there exactly one such point? Exact.
  bool is_defined() const noexcept { return denominator_ != Sign::kZero; }
  const std::array<Vec3d, 9>& points() const { return points_; }
  const internal::ImplicitLayer& layer() const { return layer_; }
  /// The sign of the determinant of the three normals (b - a) x (c - a).
  Sign denominator_sign() const { return denominator_; }

 private:
  std::array<Vec3d, 9> points_;
  internal::ImplicitLayer layer_;
  Sign denominator_;
};

/// Like orient3d(a, b, c, d) of explicit points: positive iff a, b, c turn counter-clockwise as seen from d; zero iff d
/// lies on their plane. Exact for all finite coordinates. Neither this nor the constructors allocate, unless the
/// coordinates' bits span more than 124 binary places or the largest is below approximately 2^-900.
/// REQUIRES d.is_defined(), finite coordinates. Throws InternalError for a point that is not defined.
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const LinePlanePoint& d,
              TierCounts* tally = nullptr);
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const ThreePlanePoint& d,
              TierCounts* tally = nullptr);

namespace internal {
/// The filter's constants times what their formulas count: docs/bounds/implicit_point.md. They hold in every
/// rounding mode, with FTZ and DAZ, too.
inline constexpr double kLinePlaneRel = 0x1.320000000001cp-43;
inline constexpr double kThreePlanesRel = 0x1.e600000000043p-40;
inline constexpr double kImplicitAbs = 0x1p-200;
/// The filter answers only if no difference exceeds this.
inline constexpr double kImplicitReach = 0x1p100;

Sign3 implicit_filter(const ImplicitLayer& layer, const Vec3d& base, const Vec3d& a, const Vec3d& b,
                      const Vec3d& c) noexcept;
// The later tiers, for both kinds of points; each is exact, or uncertain. Their result is the sign of the orientation
// times that of the denominator.
template <typename Point>
Sign3 implicit_lattice(const Point& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept;
template <typename Point>
Sign3 implicit_interval(const Point& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept;
// Computes in two limbs if they suffice, otherwise by implicit_integer, which takes any exponents.
template <typename Point>
Sign implicit_exact(const Point& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept;
template <typename Point>
Sign implicit_integer(const Point& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept;
}  // namespace internal

}  // namespace veritope
