// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/intersection_contact.h: what kind of contact undecided pairs of rectangles hold.
#pragma once
#include <optional>
#include <vector>

#include "interval/intersect/surface_intersection.h"

namespace veritope {

/// A pair of points with parallel normals along their connecting line, proved to be the only one in the box.
struct CommonNormal {
  Box4 parameters;      ///< narrow
  Box4 unique_in;       ///< no other in here
  Interval separation;  ///< of the second point from the first, along the first's unit normal
  IntersectionContact::Shape shape = IntersectionContact::Shape::kUnknown;
};

/// Krawczyk's operator for (S1 - S2).S1_u = (S1 - S2).S1_v = N1.S2_s = N1.S2_t = 0 about the middle of x. Elliptic iff
/// the Jacobian's determinant is positive: it is det(I) det(II2 - M^T II1 M) where the surfaces touch.
/// REQUIRES a live ScopedUpward.
std::optional<CommonNormal> find_common_normal(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                               const Box4& x);

/// On `first` parameters (u, v) in a rectangle of the first surface, S1(u, v) = S2(s, t) with s and t affine in one of
/// u, v each.
struct ExactOverlap {
  Box4 parameters;                               ///< rounded outward
  std::array<std::array<Rational, 2>, 4> exact;  ///< the bounds
  /// s = factor u + offset, or of v, and t of the other one.
  bool is_swapped = false;
  std::array<Rational, 2> factor, offset;  ///< of s, of t
};
/// Whether the overlap holds all common points of a box: one of the surfaces is one-to-one there by its derivatives.
bool holds_all_of(const EnclosedSurface& s1, const EnclosedSurface& s2, const ExactOverlap& overlap,
                  const Box4& x);

/// Looks for one near pairs of points with nearly equal positions, given as (u, v, s, t), and proves it in rational
/// numbers.
std::optional<ExactOverlap> find_overlap(const BSpline<Rational, 2>& first,
                                         const BSpline<Rational, 2>& second,
                                         const std::vector<Point4>& pairs);

}  // namespace veritope
