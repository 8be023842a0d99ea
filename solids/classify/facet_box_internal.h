// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/facet_box_internal.h: do a closed triangle and a closed box along the axes have a common point?
// Internal to solids/classify.
#pragma once
#include <array>

#include "predicates/vec.h"
#include "robust/base/box3d.h"

namespace veritope::internal {

/// Exact, degenerate triangles and boxes included. REQUIRES finite coordinates and a box that is not empty.
/// Two convex polyhedra miss each other iff a plane separates them that is parallel to a facet of one of them, or to an
/// edge of each: three planes of the box, that of the triangle, and nine that are seen as lines along an axis.
bool facet_meets(const std::array<Vec3d, 3>& facet, const Box3d& box);

}  // namespace veritope::internal
