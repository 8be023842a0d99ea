// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/surface_intersection.h: where two B-spline surfaces meet, with proofs: every branch as a chain of
// boxes that holds exactly one arc, the contacts that are not transversal, and a statement of what is left open.
// Design: docs/design/0013-surface-intersection.md.  Seed 004 section 3 (its ISI), with Krawczyk's operator.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "interval/intersect/intersection_curve.h"
#include "interval/intersect/intersection_search.h"

namespace veritope {

struct IntersectionOptions {
  IntersectionBudget budget;
  /// The bound to prove for the gap of every curve segment, in model units; 0: 2^-24 of the first surface's extent.
  double gap = 0;
};

/// One connected component of the transversal intersection.
struct IntersectionBranch {
  bool is_closed = false;
  bool is_partial = false;             ///< begins or ends at an unresolved place
  std::size_t num_boxes = 0;           ///< tubes that prove the branch, in the branch's order
  std::vector<CurveSegment> segments;  ///< working parameters: see EnclosedSurface
  Interval length;
  double gap = 0;
};

/// A place where it is proved neither that the surfaces cross transversally nor that they are apart.
struct IntersectionContact {
  enum class Kind {
    /// exactly one pair of points with parallel normals whose connecting line is normal, too: see separation
    kTangency,
    kOverlap,     ///< the surfaces are the same on `parameters`, proved in rational numbers
    kUnresolved,  ///< neither was proved within the budget
  };
  enum class Shape { kUnknown, kElliptic, kHyperbolic };
  Kind kind = Kind::kUnresolved;
  Shape shape = Shape::kUnknown;
  Box4 parameters;  ///< a rectangle of each surface's working parameters
  Box3 space;       ///< around the part of the first surface there
  /// For a tangency: the separation of the pair of points along the first surface's unit normal; contains 0. If the
  /// surfaces touch, they do so in an isolated point (elliptic) or where two arcs cross (hyperbolic). The box is
  /// smaller than 2^-12 of a span in every parameter.
  Interval separation;
  std::size_t num_boxes = 0;  ///< undecided pairs of rectangles in it
  std::string reason;
};

struct SurfaceIntersection {
  std::vector<IntersectionBranch> branches;
  std::vector<IntersectionContact> overlaps, tangencies, unresolved;
  std::uint64_t pairs = 0, proofs = 0;  ///< work done: pairs of rectangles compared, tubes tried
  /// Whether nothing is left open: the branches, overlaps and tangencies contain all common points.
  bool is_complete() const { return unresolved.empty(); }
};

/// @error as EnclosedSurface::make, with the surface ("first", "second")
Result<SurfaceIntersection> intersect(const BSpline<Rational, 2>& first,
                                      const BSpline<Rational, 2>& second,
                                      const IntersectionOptions& options = {});

}  // namespace veritope
