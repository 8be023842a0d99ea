// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/ray_count_internal.h: the winding number by a ray through all facets, for the rare points for which
// no reference point serves. Internal to solids/classify.
#pragma once
#include "solids/classify/segment_count_internal.h"

namespace veritope::internal {

/// How the winding number changes from far away to q, along the ray from q in the direction +x, by the stab rule of
/// docs/certificates/mesh.md, section 6. REQUIRES q on no facet. @cost O(F)
WindingChange change_along_ray(const TriangleMesh& mesh, const Vec3d& q, const MeshShells* shells);
WindingChange change_along_ray(const TriangleMesh& mesh, const ScaledPoint& q,
                               const MeshShells* shells);

}  // namespace veritope::internal
