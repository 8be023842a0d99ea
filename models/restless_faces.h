// SPDX-License-Identifier: LGPL-3.0-or-later
// models/restless_faces.h: solids with flat faces whose parameters are nothing like coordinates of their planes.
#pragma once
#include <cstdint>

#include "models/patch_shapes.h"

namespace veritope::patch_shapes {

/// The cube [0,1]^3 whose patches at z = 0 and z = 1 have the degrees (n, n): the inner control points of a grid are
/// moved in the plane, by at most 1/(5n), as the seed says. Both maps are one to one: seen along either axis of the
/// parameters, a difference of neighbours is more than 3/5 of that of the grid, and less than 2/5 of it across. Most
/// rational points of these faces have parameters of a degree like n^2. REQUIRES 2 <= n <= kMaxPatchDegree.
Patches restless_cube(int n, std::uint64_t seed);

}  // namespace veritope::patch_shapes
