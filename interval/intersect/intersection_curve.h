// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/intersection_curve.h: a proved branch as two chains of cubic curves in the parameter domains, with
// a proved bound of the gap between their images.
#pragma once
#include <array>
#include <vector>

#include "interval/intersect/intersection_branches.h"

namespace veritope {

/// Control points of a cubic in (u, v, s, t): the images S1(u, v) and S2(s, t) run along one arc. The next
/// segment of a branch begins where this one ends.
struct CurveSegment {
  std::array<Point4, 4> control;
  /// |S1(u, v) - S2(s, t)| <= gap at every point of the segment.
  double gap = 0;
  /// The arc between the ends' true places lies in this box of parameters, and in space.
  Box4 parameters;
  Box3 space;
  /// The length of the arc between the ends' true places.
  Interval length;
};

/// REQUIRES a live ScopedUpward. Segments are halved until their gap is at most `gap`, or 2^-12 of a step is reached.
/// Cost: approximately 20 evaluations of both surfaces per segment.
std::vector<CurveSegment> trace_branch(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                       const BranchSet& set, const BranchChain& chain, double gap);

/// A box around the part of the arc over `place`. REQUIRES inner in place, in the tube's range.
Box4 box_over(const EnclosedSurface& s1, const EnclosedSurface& s2, const DomainArc& arc,
              const Interval& place, double inner);
/// An upper bound of that part's length.
double length_over(const EnclosedSurface& s1, const DomainArc& arc, const Interval& place);

/// A bound of |S1 - S2| along a cubic of unknown quality, such as another program's curve. Infinite if the cubic leaves
/// the domains by more than a few units in the last place.
double gap_of_cubic(const EnclosedSurface& s1, const EnclosedSurface& s2,
                    const std::array<Point4, 4>& control);

namespace internal {
/// max over [-1, 1] of |p| <= this times the maximum over the n + 1 nodes of chebyshev_nodes, for polynomials p of
/// degree n. (2 / pi) ln(n + 1) + 1 for the exact nodes [Riv90]; the rest pays for their rounding.
double lebesgue_bound(std::size_t degree);
/// The Chebyshev nodes cos((2 k + 1) pi / (2 n + 2)), mapped to [0, 1] and rounded; decreasing.
std::vector<double> chebyshev_nodes(std::size_t degree);
}  // namespace internal

}  // namespace veritope
