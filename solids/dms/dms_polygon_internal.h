// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_polygon_internal.h: convex polygons in planes of space, with exact corners, which are cut by segments
// and cut into triangles.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "predicates/exact_point.h"
#include "solids/dms/dms_knots.h"

namespace veritope::internal {

/// Points by their numbers; equal ones have one number.
class DmsPoints {
 public:
  std::uint32_t add(DmsPoint p);
  const ExactPoint3& at(std::uint32_t number) const { return points_[number]; }

 private:
  std::deque<ExactPoint3> points_;
  std::unordered_multimap<std::size_t, std::uint32_t> by_hash_;
};

/// Corners in order, counter-clockwise; three successive ones may be on one line.
using DmsPolygon = std::vector<std::uint32_t>;
/// Both ends may be equal.
using DmsSegment = std::array<std::uint32_t, 2>;

/// A plane of space, as seen from the tip of its normal.
class DmsDrawingPlane {
 public:
  /// REQUIRES a normal that is not 0. The points must outlive this object.
  DmsDrawingPlane(DmsPoints& points, const DmsPoint& normal);

  /// Positive if the way from a over b to c turns to the left. REQUIRES points in a plane with this normal.
  Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  /// The two parts of a polygon beside the line through a segment; nothing if the segment does not reach into it. A
  /// segment that is a point is given a line.
  std::optional<std::pair<DmsPolygon, DmsPolygon>> cut(const DmsPolygon& polygon,
                                                       const DmsSegment& segment) const;
  /// Triangles that make up the polygon: itself, or all that have a side of it and the mean of its corners. They are
  /// more than ears would be, but ears are so thin that models of six tetrahedra had no star boxes.
  /// REQUIRES corners that are not all on one line.
  std::vector<std::array<std::uint32_t, 3>> triangles(const DmsPolygon& polygon) const;

 private:
  std::uint32_t crossing(const DmsSegment& line, std::uint32_t a, std::uint32_t b) const;
  Integer height(const DmsSegment& line, std::uint32_t p) const;

  DmsPoints& points_;
  int axis_;  // along which the plane is looked at
  Sign up_;   // the sign of the normal along it
};

/// Is p on the segment from a to b, not an end of it? REQUIRES a != b.
bool is_between(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& p);
/// The polygon with those of the points that lie inside of its sides as corners, too.
DmsPolygon with_corners(const DmsPoints& points, const DmsPolygon& polygon,
                        std::span<const std::uint32_t> candidates);

}  // namespace veritope::internal
