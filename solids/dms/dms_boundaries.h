// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_boundaries.h: whether the boundaries of two domains are one set of points, however they are cut into
// faces; decided exactly.
// Design: docs/design/0103-attribute-domains-and-splits.md.
#pragma once
#include <optional>

#include "solids/dms/dms_model.h"

namespace veritope {

/// A point inside of a face of one boundary that is not on the other boundary.
struct DmsBoundaryPoint {
  bool is_of_second = false;  ///< the face is one of the second domain
  TetrahedronFace face = 0;
  DmsPoint point;
};

/// Nothing if the boundaries are equal as sets. Each face is compared with the faces of the other boundary in its
/// plane: what they leave of it is cut out as convex polygons. The boundary of a domain bounds nothing else, so domains
/// with equal boundaries are equal sets, too.
/// REQUIRES two models whose tetrahedra form domains (find_geometry_defects).
/// @cost near-linear, and for each face a few products for each face of the other boundary that overlaps it
std::optional<DmsBoundaryPoint> find_boundary_difference(const DmsModel& first,
                                                         const DmsModel& second);

}  // namespace veritope
