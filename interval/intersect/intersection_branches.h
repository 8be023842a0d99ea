// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/intersection_branches.h: from tubes that cover the common points of two surfaces to branches:
// which tubes hold parts of one arc, in which order, and where the border of a domain cuts the arc.
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
  /// `entry` encloses `from`: the place on this arc where the previous step ends, or where the border is. `exit`
  /// encloses the step's own end if that is on a border.
  Interval entry, exit;
};
/// A connected component of the common points in the closed domains: a closed curve, or one between two points of the
/// border.
struct BranchChain {
  bool is_closed = false;
  /// The chain begins or ends where its continuation is unknown: `unresolved` contains the place.
  bool is_partial = false;
  std::vector<BranchStep> steps;
};

struct BranchSet {
  std::vector<DomainArc> arcs;
  std::vector<BranchChain> chains;
  /// Places where an arc touches or runs along a domain's border, or where two arcs may be one. If this is empty, the
  /// chains are all components of the common points in the tubes.
  std::vector<Box4> unresolved;
};

/// REQUIRES a live ScopedUpward.
BranchSet join_branches(const EnclosedSurface& s1, const EnclosedSurface& s2,
                        const std::vector<IntersectionTube>& tubes);

}  // namespace veritope
