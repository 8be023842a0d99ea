// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/session.h: the predicates for many tuples of one model. The filter's bound is computed
// once, for the model's box, so that a decision costs the determinant and one comparison.
// Source: static filters, [She97] section 6; bound: docs/bounds/README.md, 7.
#pragma once
#include <cstddef>

#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "robust/base/check.h"

namespace veritope {

/// The exact signs of orient2d and in_circle for points of one box. Immutable: threads may share it.
/// The larger the box is compared with the tuples, the more of them the filter leaves to later tiers; the
/// signs stay exact.
class Session2d {
 public:
  /// REQUIRES finite lo <= hi.
  Session2d(Vec2d lo, Vec2d hi);
  /// The session of the box of n points. REQUIRES finite points. O(n).
  static Session2d around(const Vec2d* points, std::size_t n);

  bool contains(Vec2d p) const noexcept {
    return lo_.x <= p.x && p.x <= hi_.x && lo_.y <= p.y && p.y <= hi_.y;
  }
  /// Like the functions of these names. REQUIRES that contains() holds for each point.
  Sign orient2d(const Vec2d& a, const Vec2d& b, const Vec2d& c, TierCounts* tally = nullptr) const;
  Sign in_circle(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d,
                 TierCounts* tally = nullptr) const;

 private:
  Vec2d lo_, hi_;
  double orient_error_, circle_error_;
};

/// What orient3d of a session keeps of a plane through three points, for many further points.
struct SessionPlane {
  Vec3d point;            ///< a
  FilterReal x, y, z;     ///< the normal (b - a) x (c - a), rounded as in formulas::Plane3
};

/// The exact signs of orient3d and in_sphere for points of one box in space, like Session2d in the plane.
class Session3d {
 public:
  /// REQUIRES finite lo <= hi.
  Session3d(const Vec3d& lo, const Vec3d& hi);
  /// The session of the box of n points. REQUIRES finite points. O(n).
  static Session3d around(const Vec3d* points, std::size_t n);

  bool contains(const Vec3d& p) const noexcept {
    return lo_.x <= p.x && p.x <= hi_.x && lo_.y <= p.y && p.y <= hi_.y && lo_.z <= p.z &&
           p.z <= hi_.z;
  }
  /// Like the functions of these names. REQUIRES that contains() holds for each point.
  Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                TierCounts* tally = nullptr) const;
  Sign in_sphere(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, const Vec3d& e,
                 TierCounts* tally = nullptr) const;

  /// REQUIRES points of the box.
  static SessionPlane plane(const Vec3d& a, const Vec3d& b, const Vec3d& c);
  /// The first tier of orient3d(a, b, c, d) for plane(a, b, c), bit for bit; never zero. REQUIRES contains(d).
  Sign3 orient3d_filter(const SessionPlane& plane, const Vec3d& d) const;
  /// A bound on the error of plane_value.
  double orient3d_error() const { return orient_error_; }
  /// The value whose sign the filter takes.
  static double plane_value(const SessionPlane& plane, const Vec3d& d);

 private:
  Vec3d lo_, hi_;
  double orient_error_, sphere_error_;
};

// Bodies.

inline Sign Session2d::orient2d(const Vec2d& a, const Vec2d& b, const Vec2d& c,
                                TierCounts* tally) const {
  VT_SLOW_CHECK(contains(a) && contains(b) && contains(c), "a point outside of the session's box");
  return cascade(
      tally,
      [&]() VT_TIER {
        return sign_beyond(formulas::Orient2d<FilterReal>(a.x, a.y, b.x, b.y, c.x, c.y).det(),
                           orient_error_);
      },
      [&](TierCounts* t) VT_TIER { return internal::orient2d_after_filter(a, b, c, t); });
}

inline Sign Session2d::in_circle(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d,
                                 TierCounts* tally) const {
  VT_SLOW_CHECK(contains(a) && contains(b) && contains(c) && contains(d),
                "a point outside of the session's box");
  return cascade(
      tally,
      [&]() VT_TIER {
        return sign_beyond(
            formulas::InCircle<FilterReal>(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y).det(),
            circle_error_);
      },
      [&](TierCounts* t) VT_TIER { return internal::in_circle_after_filter(a, b, c, d, t); });
}

inline Sign Session3d::orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                                TierCounts* tally) const {
  VT_SLOW_CHECK(contains(a) && contains(b) && contains(c) && contains(d),
                "a point outside of the session's box");
  return cascade(
      tally,
      [&]() VT_TIER {
        const formulas::Plane3<FilterReal> plane(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
        return sign_beyond(plane.det(d.x - a.x, d.y - a.y, d.z - a.z), orient_error_);
      },
      [&](TierCounts* t) VT_TIER { return internal::orient3d_after_filter(a, b, c, d, t); });
}

inline SessionPlane Session3d::plane(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const formulas::Plane3<FilterReal> p(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
  return {a, p.yz - p.zy, p.zx - p.xz, p.xy - p.yx};
}

inline double Session3d::plane_value(const SessionPlane& plane, const Vec3d& d) {
  const FilterReal wx = d.x - plane.point.x, wy = d.y - plane.point.y, wz = d.z - plane.point.z;
  return (wx * plane.x + wy * plane.y) + wz * plane.z;
}

inline Sign3 Session3d::orient3d_filter(const SessionPlane& plane, const Vec3d& d) const {
  return sign_beyond(plane_value(plane, d), orient_error_);
}

inline Sign Session3d::in_sphere(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                                 const Vec3d& e, TierCounts* tally) const {
  VT_SLOW_CHECK(contains(a) && contains(b) && contains(c) && contains(d) && contains(e),
                "a point outside of the session's box");
  return cascade(
      tally,
      [&]() VT_TIER {
        const formulas::InSphere<FilterReal> f(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x,
                                               d.y, d.z, e.x, e.y, e.z);
        return sign_beyond(f.det(), sphere_error_);
      },
      [&](TierCounts* t) VT_TIER { return internal::in_sphere_after_filter(a, b, c, d, e, t); });
}

}  // namespace veritope
