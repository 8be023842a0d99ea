// SPDX-License-Identifier: LGPL-3.0-or-later
// render/crossing_curves.h: the curves in which two tessellated surfaces cross, for pictures.
#pragma once
#include <array>
#include <vector>

#include "render/scene.h"

namespace veritope {

/// The segments in which triangles of the two surfaces cross, approximately. Neighbours, which have a common point, get
/// none, because the triangles along their common side would seem to cross; nor do surfaces of which too many triangles
/// would have to be compared. @cost O(n log n) for n triangles, and approximately 20 ns for each pair of them that
/// overlaps along the first axis, of which there are at most 2^26
std::vector<std::array<Point3d, 2>> approx_crossing(const SceneSurface& a, const SceneSurface& b);

}  // namespace veritope
