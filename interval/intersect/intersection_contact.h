// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/intersection_contact.h: the kind of contact in undecided pairs of rectangles.
#pragma once
#include <optional>
#include <vector>

#include "interval/intersect/surface_intersection.h"

namespace veritope {

/// A pair of points with parallel normals along their connecting line, proved to be the only one in the box.
struct CommonNormal {
  Box4 parameters;      ///< narrow
  Box4 unique_in;       ///< contains no other such pair
  Interval separation;  ///< of the second point from the first, along the first's unit normal
  IntersectionContact::Shape shape = IntersectionContact::Shape::kUnknown;
};

/// Krawczyk's operator for (S1 - S2).S1_u = (S1 - S2).S1_v = N1.S2_s = N1.S2_t = 0 about the middle of x. Elliptic iff
/// the Jacobian's determinant is positive: it is det(I) det(II2 - M^T II1 M) where the surfaces touch.
/// REQUIRES a live ScopedUpward.
std::optional<CommonNormal> find_common_normal(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                               const Box4& x);

/// A common area: for all (u, v) in a rectangle of the first surface, S1(u, v) = S2(s, t), where each of s and t is
/// affine in one of u, v.
struct ExactOverlap {
  Box4 parameters;                               ///< rounded outward
  std::array<std::array<Rational, 2>, 4> exact;  ///< the bounds
  /// s = factor u + offset or factor v + offset, and t depends on the other parameter.
  bool is_swapped = false;
  std::array<Rational, 2> factor, offset;  ///< of s, of t
};
/// True if it is proved that the overlap contains all common points of a box; the proof uses the derivatives of one
/// surface, which is one-to-one there.
bool holds_all_of(const EnclosedSurface& s1, const EnclosedSurface& s2, const ExactOverlap& overlap,
                  const Box4& x);

/// Searches for an overlap near pairs of points with nearly equal positions, given as (u, v, s, t), and proves the
/// overlap in rational numbers.
std::optional<ExactOverlap> find_overlap(const BSpline<Rational, 2>& first,
                                         const BSpline<Rational, 2>& second,
                                         const std::vector<Point4>& pairs);

}  // namespace veritope
