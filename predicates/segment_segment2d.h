// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/segment_segment2d.h: how do two closed segments in the plane meet?
#pragma once
#include <cstdint>

#include "predicates/vec.h"
#include "robust/cascade.h"

namespace veritope {

/// What the intersection of two closed segments is. A segment may be a point, which counts as its
/// two ends.
enum class SegmentContact : std::uint8_t {
  kDisjoint,   ///< empty
  kCrossing,   ///< one point, inside both
  kEndInside,  ///< one point, an end of exactly one of them
  kEnds,       ///< one point, an end of both
  kOverlap,    ///< more than one point: both lie on one line
};

/// The exact classification of the segments p0 p1 and q0 q1. Symmetric under swapping the segments
/// and the ends of each.
/// REQUIRES finite coordinates.
SegmentContact segment_segment2d(Vec2d p0, Vec2d p1, Vec2d q0, Vec2d q1,
                                 TierCounts* tally = nullptr) noexcept;

}  // namespace veritope
