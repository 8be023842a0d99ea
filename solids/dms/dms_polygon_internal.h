// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_polygon_internal.h: convex polygons in a plane of space, with exact corners, which are cut by lines.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "solids/dms/dms_knots.h"

namespace veritope::internal {

/// Corners in order; three successive ones may be on one line.
using DmsPolygon = std::vector<DmsPoint>;
/// Both ends may be equal.
using DmsSegment = std::array<DmsPoint, 2>;

/// The two parts of a polygon beside the line through a segment; nothing if the segment does not reach into it. A
/// segment that is a point is given a line. `normal` is that of the polygon's plane, in which the segment lies.
std::optional<std::pair<DmsPolygon, DmsPolygon>> cut_polygon(const DmsPolygon& polygon,
                                                             const DmsSegment& segment,
                                                             const DmsPoint& normal);
/// Is p on the segment from a to b, not an end of it? REQUIRES a != b.
bool is_between(const DmsPoint& a, const DmsPoint& b, const DmsPoint& p);
/// The polygon with those of the points that lie inside of its sides as corners, too.
DmsPolygon with_corners(const DmsPolygon& polygon, const std::vector<DmsPoint>& points);
/// Triangles with all corners of the polygon, and perhaps its middle.
std::vector<std::array<DmsPoint, 3>> triangles_of(const DmsPolygon& polygon);

}  // namespace veritope::internal
