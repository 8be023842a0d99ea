// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/defect_picture.h: the listed defects in a copy of the model, to look at in any viewer of PLY files.
#pragma once
#include <span>
#include <string>

#include "cli/file_report.h"
#include "render/coloured_ply.h"

namespace veritope::cli {

/// The colour of a rule's defects; those of rule M1 come first where a face has several.
Colour colour_of(MeshRule rule);

/// The model in grey, the faces of each defect in the colour of its rule, and an octahedron of that colour around the defect's point, so
/// that a defect too small to be seen is found. @cost O(faces + defects)
std::string defect_picture(const TriangleMesh& mesh, std::span<const ListedDefect> defects);

}  // namespace veritope::cli
