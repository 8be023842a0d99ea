// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/edge_gap.h: whether two edges of a mesh lie beside each other like the two sides of a crack, and
// the gap between them.
#pragma once
#include "predicates/vec.h"
#include "robust/base/box3d.h"
#include "robust/base/sign.h"
#include "robust/rational.h"

namespace veritope {

/// An edge as a set of points. All coordinates are finite, any are allowed; a = b is an edge of length 0.
struct EdgeEnds {
  Vec3d a, b;
};

/// Whether e and f run along each other: the angle between their lines is less than 30 degrees, and the middle of one
/// of them is projected into the other one (an end counts), along the other's line. Exact, and symmetric in e and f.
/// Edges that only continue one another do not run along each other, whether they share a vertex or not, and neither do
/// the sides of a corner. An edge of length 0 has no line: it runs along no other edge.
bool run_along(const EdgeEnds& e, const EdgeEnds& f);

/// The square of the gap, exactly. The gap of e and f is the lesser one of two numbers: the greatest distance of a
/// point of e from f, and the greatest distance of a point of f from e. So one of the two edges lies within the gap of
/// the other one. Distance from a convex set is a convex function, so each of the two numbers is attained at an end.
/// @cost  approximately 5 microseconds
Rational squared_gap(const EdgeEnds& e, const EdgeEnds& f);
/// Whether the gap is 0: one of the edges is a part of the other one. Exact. @cost approximately 0.1 microseconds
bool has_no_gap(const EdgeEnds& e, const EdgeEnds& f);

Rational squared_length(const EdgeEnds& e);

/// The binary64 number nearest to the square root of a, ties to even. It is finite wherever the root is in the range of
/// finite numbers, even if a is not. REQUIRES a >= 0.
double nearest_root(const Rational& a);

namespace internal {

/// An edge in coordinates below 2^501 in magnitude: those of the mesh times one power of two, rounded where the product
/// is subnormal. The functions below need rounding to nearest and gradual underflow (ScopedDefaultFp).
struct ScaledEdge {
  Point3d a, b;
  double squared_length, length;  ///< rounded
};
ScaledEdge scaled_edge(const Point3d& a, const Point3d& b);

/// Errors of distances between scaled edges that are due to underflow, and to coordinates rounded by the scale, stay
/// below this number.
inline constexpr double kEdgeGapFloor = 0x1p-490;
/// Errors of a distance due to rounding stay below kEdgeGapRel * |w|, where w is the difference of the point and the
/// end from which its foot was computed. Derivation: edge_gap.cc.
inline constexpr double kEdgeGapRel = 0x1p-48;  // 32 u

/// The gap lies in [lo, hi].
struct GapBounds {
  double lo, hi;
};
GapBounds gap_bounds(const ScaledEdge& e, const ScaledEdge& f);

/// The square of a number that differs from the gap by at most kEdgeGapRel * (the gap + the greater length) +
/// kEdgeGapFloor, or infinity if that number exceeds `limit`.
double approx_squared_gap(const ScaledEdge& e, const ScaledEdge& f, double limit);

/// kPositive: they run along each other. kNegative: they do not.
Sign3 run_along_filter(const ScaledEdge& e, const ScaledEdge& f);

}  // namespace internal

}  // namespace veritope
