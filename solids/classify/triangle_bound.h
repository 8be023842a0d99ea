// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/triangle_bound.h: how far points are from a triangle, at most.
#pragma once
#include <array>

#include "interval/box.h"
#include "predicates/vec.h"
#include "robust/base/box3d.h"

namespace veritope {

/// Weights v, w of the second and the third corner for a point of the triangle near the nearest one to q: v, w and
/// 1 - v - w are at least 0, but for rounding. Approximate.
std::array<double, 2> near_weights(const Point3d& q, const std::array<Vec3d, 3>& triangle);

/// No point of the box is farther from the closed triangle; a few units in the last place over the distance of a box
/// that is a point. Infinite or NaN only for coordinates near the end of the range of binary64.
/// REQUIRES a live ScopedUpward.
double distance_bound(const Box3& point, const std::array<Vec3d, 3>& triangle);

}  // namespace veritope
