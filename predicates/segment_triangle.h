// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/segment_triangle.h: where does a closed segment in space meet a closed triangle?
#pragma once
#include <array>
#include <cstdint>

#include "predicates/vec.h"
#include "robust/cascade.h"

namespace veritope {

/// What the intersection is.
enum class SegmentTriangleKind : std::uint8_t {
  kDisjoint,
  kVertex,    ///< one point: corner `part` of the triangle
  kEdge,      ///< one point inside the edge from corner `part` to the next
  kInterior,  ///< one point inside the triangle
  kOverlap,   ///< more than one point: the segment lies in the triangle's plane
};

struct SegmentTriangleContact {
  SegmentTriangleKind kind = SegmentTriangleKind::kDisjoint;
  int part = 0;         ///< see kind; 0 for the kinds without a part
  bool at_end = false;  ///< the one common point is an end of the segment
  friend bool operator==(const SegmentTriangleContact&,  // NOT COVERED: the compiler counts no outcome false
                         const SegmentTriangleContact&) = default;
};

/// The exact classification of the segment p q and the triangle t. The segment may be a point,
/// which counts as its end.
/// REQUIRES finite coordinates and a non-degenerate triangle.
SegmentTriangleContact segment_triangle(const Vec3d& p, const Vec3d& q,
                                        const std::array<Vec3d, 3>& t,
                                        TierCounts* tally = nullptr) noexcept;

}  // namespace veritope
