// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_iso_mesh_internal.h: marching tetrahedra.
#pragma once
#include "solids/dms/dms_iso.h"
#include "solids/dms/dms_iso_cells_internal.h"

namespace veritope::internal {

/// The triangles between corners of unlike signs, one vertex on each edge that has such; `components` and `euler` are
/// theirs. Vertices are images by `map`, points of the domain if it is null. A corner where g = c counts as one where g
/// is more. With `keeps_places` out.places has the points of the domain.
/// @error kNotFinite for a vertex beyond binary64, with the tetrahedron as the entity
Status draw_iso(IsoCells& cells, DmsEvaluator* map, bool keeps_places, DmsIso& out);

}  // namespace veritope::internal
