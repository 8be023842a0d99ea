// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/implicit_kinds.h: the other points that doubles cannot hold: on a segment or a triangle, given by rational
// weights, and in the plane, where two lines meet; and one view of points of every kind.
// Source: [Att20]; the weighted points generalise its LNC and BPT.
#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "predicates/implicit_point.h"
#include "predicates/vec.h"
#include "robust/binary64.h"

namespace veritope {

namespace internal {
/// Subnormal numbers are not zero, whatever DAZ says.
inline bool is_zero_by_bits(double v) { return integer_bits(v) << 1 == 0; }
}  // namespace internal

/// The point a + (b - a) numerator / denominator. The weight is a ratio of any two finite doubles, so
/// of any two integers up to 2^53. Immutable.
class SegmentPoint {
 public:
  /// REQUIRES finite numbers.
  SegmentPoint(const Vec3d& a, const Vec3d& b, double numerator, double denominator) noexcept;
  /// denominator != 0
  bool is_defined() const noexcept { return !internal::is_zero_by_bits(weights_[1]); }
  /// a, b
  const std::array<Vec3d, 2>& points() const { return points_; }
  /// The numerator and the denominator, negated if the latter was negative.
  const std::array<double, 2>& weights() const { return weights_; }

 private:
  std::array<Vec3d, 2> points_;
  std::array<double, 2> weights_;
};

/// The point a + ((b - a) v + (c - a) w) / denominator. Immutable.
class TrianglePoint {
 public:
  /// REQUIRES finite numbers.
  TrianglePoint(const Vec3d& a, const Vec3d& b, const Vec3d& c, double v, double w,
                double denominator) noexcept;
  /// denominator != 0
  bool is_defined() const noexcept { return !internal::is_zero_by_bits(weights_[2]); }
  /// a, b, c
  const std::array<Vec3d, 3>& points() const { return points_; }
  /// v, w and the denominator, negated if the last was negative.
  const std::array<double, 3>& weights() const { return weights_; }

 private:
  std::array<Vec3d, 3> points_;
  std::array<double, 3> weights_;
};

/// The point a + (b - a) numerator / denominator of the plane. Immutable.
class SegmentPoint2d {
 public:
  /// REQUIRES finite numbers.
  SegmentPoint2d(const Vec2d& a, const Vec2d& b, double numerator, double denominator) noexcept;
  /// denominator != 0
  bool is_defined() const noexcept { return !internal::is_zero_by_bits(weights_[1]); }
  const std::array<Vec2d, 2>& points() const { return points_; }
  const std::array<double, 2>& weights() const { return weights_; }

 private:
  std::array<Vec2d, 2> points_;
  std::array<double, 2> weights_;
};

/// The point of the plane where the line through a and b meets the line through c and d. Immutable.
class SegmentSegmentPoint2d {
 public:
  /// REQUIRES finite coordinates.
  SegmentSegmentPoint2d(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) noexcept;
  /// Is there exactly one such point? Exact.
  bool is_defined() const noexcept { return denominator_ != Sign::kZero; }
  /// a, b, c, d
  const std::array<Vec2d, 4>& points() const { return points_; }
  /// The sign of (b - a) x (d - c).
  Sign denominator_sign() const { return denominator_; }

 private:
  std::array<Vec2d, 4> points_;
  Sign denominator_;
};

template <typename P>
class CachedPoint;  // predicates/implicit_cache.h

/// A point of any kind in space, for the predicates of predicates/implicit_predicates.h: a pointer and
/// a kind, no virtual call. It refers to the point, which must outlive it.
class AnyPoint3 {
 public:
  enum class Kind : std::uint8_t {  ///< the cheaper ones first
    kExplicit,
    kSegment,
    kTriangle,
    kLinePlane,
    kCachedLinePlane,
    kThreePlanes,
    kCachedThreePlanes,
  };

  AnyPoint3(const Vec3d& p) : at_(&p), kind_(Kind::kExplicit) {}
  AnyPoint3(const SegmentPoint& p) : at_(&p), kind_(Kind::kSegment) {}
  AnyPoint3(const TrianglePoint& p) : at_(&p), kind_(Kind::kTriangle) {}
  AnyPoint3(const LinePlanePoint& p) : at_(&p), kind_(Kind::kLinePlane) {}
  AnyPoint3(const ThreePlanePoint& p) : at_(&p), kind_(Kind::kThreePlanes) {}
  AnyPoint3(const CachedPoint<LinePlanePoint>& p) : at_(&p), kind_(Kind::kCachedLinePlane) {}
  AnyPoint3(const CachedPoint<ThreePlanePoint>& p) : at_(&p), kind_(Kind::kCachedThreePlanes) {}

  Kind kind() const { return kind_; }
  bool is_explicit() const { return kind_ == Kind::kExplicit; }
  /// REQUIRES that the point is a P.
  template <typename P>
  const P& as() const {
    return *static_cast<const P*>(at_);
  }

 private:
  const void* at_;
  Kind kind_;
};

/// A point of any kind in the plane, like AnyPoint3 in space.
class AnyPoint2 {
 public:
  enum class Kind : std::uint8_t { kExplicit, kSegment, kSegmentSegment };

  AnyPoint2(const Vec2d& p) : at_(&p), kind_(Kind::kExplicit) {}
  AnyPoint2(const SegmentPoint2d& p) : at_(&p), kind_(Kind::kSegment) {}
  AnyPoint2(const SegmentSegmentPoint2d& p) : at_(&p), kind_(Kind::kSegmentSegment) {}

  Kind kind() const { return kind_; }
  bool is_explicit() const { return kind_ == Kind::kExplicit; }
  /// REQUIRES that the point is a P.
  template <typename P>
  const P& as() const {
    return *static_cast<const P*>(at_);
  }

 private:
  const void* at_;
  Kind kind_;
};

}  // namespace veritope
