// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/quad_gap_internal.h: how far the bilinear patch of
// four points lies from its two triangles. Internal to solids/micro/mesh.
#pragma once
#include "predicates/vec.h"

namespace veritope::internal {

/// An upper bound of the distance between corresponding points of the bilinear patch with the corners a, b, c, d at
/// (0, 0), (1, 0), (1, 1), (0, 1) and the triangles a, b, c and a, c, d, for one continuous correspondence. A bound
/// that is not over `enough` need not be the best one that is known. REQUIRES a live ScopedUpward.
double quad_gap(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, double enough);

}  // namespace veritope::internal
