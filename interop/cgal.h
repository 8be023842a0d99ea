// SPDX-License-Identifier: LGPL-3.0-or-later
// interop/cgal.h: CGAL's algorithms on our predicates, and CGAL's points for our code. Opt-in: nothing of ours
// includes it. Tested with CGAL 5.5 [CGAL55]. Use: docs/how-to/use-with-cgal-boost-eigen.md.
#pragma once
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Triangulation_structural_filtering_traits.h>

#include <cmath>
#include <type_traits>

#include "interval/interval.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/vec.h"

namespace veritope {

/// A CGAL point for our code, exactly. Only for kernels whose coordinates are doubles: others would have to be rounded.
template <typename Kernel>
Vec2d from_cgal(const CGAL::Point_2<Kernel>& p) {
  static_assert(std::is_same_v<typename Kernel::FT, double>, "coordinates that are not doubles");
  return {p.x(), p.y()};
}
template <typename Kernel>
Vec3d from_cgal(const CGAL::Point_3<Kernel>& p) {
  static_assert(std::is_same_v<typename Kernel::FT, double>, "coordinates that are not doubles");
  return {p.x(), p.y(), p.z()};
}
/// Our point for CGAL.
template <typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
typename Kernel::Point_2 to_cgal(const Vec2d& p) {
  return typename Kernel::Point_2(p.x, p.y);
}
template <typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
typename Kernel::Point_3 to_cgal(const Vec3d& p) {
  return typename Kernel::Point_3(p.x, p.y, p.z);
}

/// Our interval with the same members.
template <bool Protected>
Interval from_cgal(const CGAL::Interval_nt<Protected>& x) {
  return Interval::from_bounds(x.inf(), x.sup());
}
/// REQUIRES a not empty.
inline CGAL::Interval_nt<false> to_cgal(const Interval& a) { return {a.lo(), a.hi()}; }

namespace internal {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using EpickPoint2 = Epick::Point_2;
using EpickPoint3 = Epick::Point_3;

// CGAL's enumerations of signs are -1, 0, 1, too.
template <typename CgalSign>
CgalSign to_cgal_sign(veritope::Sign sign) {
  return static_cast<CgalSign>(to_int(sign));
}

inline veritope::Sign cgal_orient2d(const EpickPoint2& p, const EpickPoint2& q,
                                    const EpickPoint2& r) {
  return orient2d(from_cgal(p), from_cgal(q), from_cgal(r));
}
inline veritope::Sign cgal_orient3d(const EpickPoint3& p, const EpickPoint3& q,
                                    const EpickPoint3& r, const EpickPoint3& s) {
  return orient3d(from_cgal(p), from_cgal(q), from_cgal(r), from_cgal(s));
}
inline veritope::Sign cgal_in_circle(const EpickPoint2& p, const EpickPoint2& q,
                                     const EpickPoint2& r, const EpickPoint2& t) {
  return in_circle(from_cgal(p), from_cgal(q), from_cgal(r), from_cgal(t));
}
inline veritope::Sign cgal_in_sphere(const EpickPoint3& p, const EpickPoint3& q,
                                     const EpickPoint3& r, const EpickPoint3& s,
                                     const EpickPoint3& t) {
  return in_sphere(from_cgal(p), from_cgal(q), from_cgal(r), from_cgal(s), from_cgal(t));
}

// orient2d after projection along axis 2 to xy, along 0 to yz, along 1 to xz.
inline veritope::Sign cgal_project(int axis, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  if (axis == 2) return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
  if (axis == 0) return orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z});
  return orient2d({a.x, a.z}, {b.x, b.z}, {c.x, c.z});
}
struct CgalProjected {
  int axis;
  veritope::Sign sign;
};
// The first projection, of those to xy, yz and xz in CGAL's order, that is not a line.
inline CgalProjected cgal_first_projection(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  for (const int axis : {2, 0}) {
    const veritope::Sign sign = cgal_project(axis, a, b, c);
    if (sign != veritope::Sign::kZero) return {axis, sign};
  }
  return {1, cgal_project(1, a, b, c)};
}
// a moved along an axis that the plane of a, b, c does not contain, by approximately the triangle's size, so that
// filters suffice. REQUIRES a, b, c not collinear.
inline Vec3d cgal_off_plane(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  double by = 0;
  for (const int k : {0, 1, 2})
    by = std::fmax(by, std::fmax(std::abs(b[k] - a[k]), std::abs(c[k] - a[k])));
  const auto moved = [by](double v) {
    const double w = v > 0 ? v - by : v + by;
    if (std::isfinite(w) && w != v) return w;
    return v == 0 ? 1.0 : 0.0;
  };
  const int axis = cgal_first_projection(a, b, c).axis;
  if (axis == 0) return {moved(a.x), a.y, a.z};
  return axis == 1 ? Vec3d{a.x, moved(a.y), a.z} : Vec3d{a.x, a.y, moved(a.z)};
}

struct CgalOrientation2 : Epick::Orientation_2 {
  using Epick::Orientation_2::operator();
  CGAL::Orientation operator()(const EpickPoint2& p, const EpickPoint2& q,
                               const EpickPoint2& r) const {
    return to_cgal_sign<CGAL::Orientation>(cgal_orient2d(p, q, r));
  }
};
struct CgalLeftTurn2 : Epick::Left_turn_2 {
  bool operator()(const EpickPoint2& p, const EpickPoint2& q, const EpickPoint2& r) const {
    return cgal_orient2d(p, q, r) == veritope::Sign::kPositive;
  }
};
struct CgalCollinear2 : Epick::Collinear_2 {
  bool operator()(const EpickPoint2& p, const EpickPoint2& q, const EpickPoint2& r) const {
    return cgal_orient2d(p, q, r) == veritope::Sign::kZero;
  }
};
struct CgalSideOfOrientedCircle2 : Epick::Side_of_oriented_circle_2 {
  CGAL::Oriented_side operator()(const EpickPoint2& p, const EpickPoint2& q, const EpickPoint2& r,
                                 const EpickPoint2& t) const {
    return to_cgal_sign<CGAL::Oriented_side>(cgal_in_circle(p, q, r, t));
  }
};
struct CgalSideOfBoundedCircle2 : Epick::Side_of_bounded_circle_2 {
  using Epick::Side_of_bounded_circle_2::operator();
  /// REQUIRES p, q, r not collinear.
  CGAL::Bounded_side operator()(const EpickPoint2& p, const EpickPoint2& q, const EpickPoint2& r,
                                const EpickPoint2& t) const {
    return to_cgal_sign<CGAL::Bounded_side>(cgal_in_circle(p, q, r, t) * cgal_orient2d(p, q, r));
  }
};

struct CgalOrientation3 : Epick::Orientation_3 {
  using Epick::Orientation_3::operator();
  CGAL::Orientation operator()(const EpickPoint3& p, const EpickPoint3& q, const EpickPoint3& r,
                               const EpickPoint3& s) const {
    return to_cgal_sign<CGAL::Orientation>(cgal_orient3d(p, q, r, s));
  }
};
struct CgalCoplanar3 : Epick::Coplanar_3 {
  bool operator()(const EpickPoint3& p, const EpickPoint3& q, const EpickPoint3& r,
                  const EpickPoint3& s) const {
    return cgal_orient3d(p, q, r, s) == veritope::Sign::kZero;
  }
};
struct CgalCollinear3 : Epick::Collinear_3 {
  bool operator()(const EpickPoint3& p, const EpickPoint3& q, const EpickPoint3& r) const {
    return cgal_first_projection(from_cgal(p), from_cgal(q), from_cgal(r)).sign ==
           veritope::Sign::kZero;
  }
};
struct CgalCoplanarOrientation3 : Epick::Coplanar_orientation_3 {
  CGAL::Orientation operator()(const EpickPoint3& p, const EpickPoint3& q,
                               const EpickPoint3& r) const {
    return to_cgal_sign<CGAL::Orientation>(
        cgal_first_projection(from_cgal(p), from_cgal(q), from_cgal(r)).sign);
  }
  /// Positive iff r and s lie on one side of the line through p and q. REQUIRES the four coplanar, p,
  /// q, r not collinear.
  CGAL::Orientation operator()(const EpickPoint3& p, const EpickPoint3& q, const EpickPoint3& r,
                               const EpickPoint3& s) const {
    const Vec3d a = from_cgal(p), b = from_cgal(q);
    const CgalProjected first = cgal_first_projection(a, b, from_cgal(r));
    return to_cgal_sign<CGAL::Orientation>(first.sign *
                                           cgal_project(first.axis, a, b, from_cgal(s)));
  }
};
struct CgalCoplanarSideOfBoundedCircle3 : Epick::Coplanar_side_of_bounded_circle_3 {
  /// Any sphere through p, q, r meets their plane in their circle, and its inside meets the plane
  /// in the circle's inside. REQUIRES the four coplanar, p, q, r not collinear.
  CGAL::Bounded_side operator()(const EpickPoint3& p, const EpickPoint3& q, const EpickPoint3& r,
                                const EpickPoint3& t) const {
    const Vec3d a = from_cgal(p), b = from_cgal(q), c = from_cgal(r), s = cgal_off_plane(a, b, c);
    return to_cgal_sign<CGAL::Bounded_side>(in_sphere(a, b, c, s, from_cgal(t)) *
                                            orient3d(a, b, c, s));
  }
};
struct CgalSideOfOrientedSphere3 : Epick::Side_of_oriented_sphere_3 {
  using Epick::Side_of_oriented_sphere_3::operator();
  CGAL::Oriented_side operator()(const EpickPoint3& p, const EpickPoint3& q, const EpickPoint3& r,
                                 const EpickPoint3& s, const EpickPoint3& t) const {
    return to_cgal_sign<CGAL::Oriented_side>(cgal_in_sphere(p, q, r, s, t));
  }
};
struct CgalSideOfBoundedSphere3 : Epick::Side_of_bounded_sphere_3 {
  using Epick::Side_of_bounded_sphere_3::operator();
  /// REQUIRES p, q, r, s not coplanar.
  CGAL::Bounded_side operator()(const EpickPoint3& p, const EpickPoint3& q, const EpickPoint3& r,
                                const EpickPoint3& s, const EpickPoint3& t) const {
    return to_cgal_sign<CGAL::Bounded_side>(cgal_in_sphere(p, q, r, s, t) *
                                            cgal_orient3d(p, q, r, s));
  }
};

}  // namespace internal

/// EPICK with our predicates in place of its own: a kernel and traits class for CGAL's algorithms
/// (Delaunay_triangulation_2 and _3, convex_hull_2, convex_hull_3 with Convex_hull_traits_3<CgalTraits, Mesh,
/// CGAL::Tag_false>, ...). Points, constructions and what is not listed here are EPICK's, so that points need no
/// conversion; EPICK's comparisons of coordinates are exact. Signs agree: CGAL's orientation is that of orient2d and
/// orient3d, its side of a circle or sphere that of in_circle and in_sphere. REQUIRES finite coordinates, and a call of
/// refresh_fp() in a scope that changes the rounding mode after the thread's first decision
/// (CGAL::Protect_FPU_rounding<true>). As with EPICK, compile with -frounding-math.
class CgalTraits : public internal::Epick {
 public:
  using Orientation_2 = internal::CgalOrientation2;
  using Left_turn_2 = internal::CgalLeftTurn2;
  using Collinear_2 = internal::CgalCollinear2;
  using Side_of_oriented_circle_2 = internal::CgalSideOfOrientedCircle2;
  using Side_of_bounded_circle_2 = internal::CgalSideOfBoundedCircle2;
  using Orientation_3 = internal::CgalOrientation3;
  using Coplanar_3 = internal::CgalCoplanar3;
  using Collinear_3 = internal::CgalCollinear3;
  using Coplanar_orientation_3 = internal::CgalCoplanarOrientation3;
  using Coplanar_side_of_bounded_circle_3 = internal::CgalCoplanarSideOfBoundedCircle3;
  using Side_of_oriented_sphere_3 = internal::CgalSideOfOrientedSphere3;
  using Side_of_bounded_sphere_3 = internal::CgalSideOfBoundedSphere3;

  Orientation_2 orientation_2_object() const { return {}; }
  Left_turn_2 left_turn_2_object() const { return {}; }
  Collinear_2 collinear_2_object() const { return {}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
  Side_of_bounded_circle_2 side_of_bounded_circle_2_object() const { return {}; }
  Orientation_3 orientation_3_object() const { return {}; }
  Coplanar_3 coplanar_3_object() const { return {}; }
  Collinear_3 collinear_3_object() const { return {}; }
  Coplanar_orientation_3 coplanar_orientation_3_object() const { return {}; }
  Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const { return {}; }
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }
  Side_of_bounded_sphere_3 side_of_bounded_sphere_3_object() const { return {}; }
};

}  // namespace veritope

namespace CGAL {
/// Point location first walks near its goal with rounded orientations, as on EPICK; only exact ones decide.
template <>
struct Triangulation_structural_filtering_traits<veritope::CgalTraits> {
  typedef Tag_true Use_structural_filtering_tag;
};
}  // namespace CGAL
