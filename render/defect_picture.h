// SPDX-License-Identifier: LGPL-3.0-or-later
// render/defect_picture.h: the listed defects in a copy of the model, to look at in any viewer of PLY files.
#pragma once
#include <span>
#include <string>

#include "render/coloured_ply.h"
#include "solids/base/finding.h"
#include "solids/polyhedron/rules.h"

namespace veritope {

/// The colour of a rule's defects. A face with several defects has the colour of the one listed
/// first.
Colour colour_of(MeshRule rule);

/// The model in grey, the faces of each defect in the colour of its rule, and an octahedron of that colour around the
/// defect's point, so that a defect too small to be seen is found. REQUIRES defects of this mesh, as decide_validity
/// lists them. @cost O(faces + defects)
std::string defect_picture(const TriangleMesh& mesh, std::span<const Finding> defects);

}  // namespace veritope
