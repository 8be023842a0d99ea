// SPDX-License-Identifier: LGPL-3.0-or-later
// render/coloured_ply.h: a mesh to look at: binary PLY whose faces have colours, for viewers such as MeshLab and
// Blender.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "render/colour.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// Little-endian, coordinates in binary64. REQUIRES one colour a face, ids in range, fewer than 2^32 faces and
/// vertices; comments of one line each, in ASCII.
std::string coloured_ply(const TriangleMesh& mesh, std::span<const Colour> colours,
                         const std::vector<std::string>& comments = {});

}  // namespace veritope
