// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/collar_solids.h: the two solids between which a collar holds the boundary of a model. Theory:
// docs/THEORY.md, COLLAR-2.
#pragma once
#include "solids/collar/collar_mesh.h"
#include "verify/certify/patch_collar.h"

namespace veritope {

/// The union of M and the cells, bounded by the components with winding number 0. `scale`: the forest's.
/// @error as boundary_mesh
Result<TriangleMesh> outer_solid(const PatchCollar& collar, int scale);
/// The closure of M without the cells: bounded by the components with winding number 1.
Result<TriangleMesh> inner_solid(const PatchCollar& collar, int scale);
/// The cells themselves.
Result<TriangleMesh> collar_solid(const PatchCollar& collar, int scale);

}  // namespace veritope
