// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/intersection_branches.h: from tubes that cover the common points of two surfaces to branches:
// which tubes hold parts of the same arc, in which order, and where the border of a domain cuts it.
#pragma once
#include <cstddef>
#include <vector>

#include "interval/intersect/intersection_tube.h"

namespace veritope {

/// The part of a tube's arc that lies in both closed domains: from w in `begin` to w in `end`, begin < end. At an end
/// on the border of a domain the interval is an enclosure of the place; elsewhere it is the tube's own end.
struct DomainArc {
  IntersectionTube tube;
  Interval begin, end;
  bool begins_on_border = false, ends_on_border = false;
};

/// A part of a branch in its order along n1 x n2: the arc from w = from to w = to (from > to if the tube runs
/// against the order). Consecutive steps share their end point.
struct BranchStep {
  std::size_t arc;
  double from, to;
  /// Where on this arc the step before ends, or the border is: around `from`. And where it ends itself, if on a border.
  Interval entry, exit;
};
/// A connected component of the common points in the closed domains: a closed curve, or one between two points of the
/// border.
struct BranchChain {
  bool is_closed = false;
  /// Begins or ends where it is not known how it goes on: `unresolved` has the place.
  bool is_partial = false;
  std::vector<BranchStep> steps;
};

struct BranchSet {
  std::vector<DomainArc> arcs;
  std::vector<BranchChain> chains;
  /// Where an arc touches or runs along a domain's border, or where it is not known whether two arcs are one. Empty:
  /// the chains are all components of what the tubes hold.
  std::vector<Box4> unresolved;
};

/// REQUIRES a live ScopedUpward.
BranchSet join_branches(const EnclosedSurface& s1, const EnclosedSurface& s2,
                        const std::vector<IntersectionTube>& tubes);

}  // namespace veritope
