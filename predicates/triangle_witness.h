// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/triangle_witness.h: a point that shows why two facets may not both be in a mesh. Slow
// and exact; for reports and certificates.
#pragma once
#include <array>

#include "predicates/triangle_triangle.h"
#include "robust/integer.h"
#include "robust/rational.h"

namespace veritope {

/// A common point of two triangles outside their common simplex, in the weights of each, and the extent of the
/// intersection.
struct TriangleWitness {
  /// point = sum t_weight[i] * t.point[i] / sum t_weight[i], and the same for u. Weights are >= 0, and those of one
  /// triangle are coprime.
  std::array<Integer, 3> t_weight, u_weight;
  std::array<Rational, 3> point;
  /// Two points of the intersection with the greatest distance, and its square; 0 iff the triangles only touch in one
  /// point.
  std::array<std::array<Rational, 3>, 2> ends;
  Rational squared_extent;
};

/// The midpoint of the intersection if that is a segment, else the mean of the corners of the
/// intersection (a convex polygon).
/// REQUIRES what triangle_triangle requires, and that it answers kImproper or kCoplanarOverlap.
TriangleWitness triangle_witness(const IndexedTriangle& t, const IndexedTriangle& u);

}  // namespace veritope
