// SPDX-License-Identifier: LGPL-3.0-or-later
// render/scene_files.h: scenes as files for viewers. Marks are tubes and octahedra (render/solid_marks.h), and every
// part has its colour and its name. The bytes are the same with every compiler.
#pragma once
#include <string>

#include "render/scene.h"
#include "robust/base/result.h"

namespace veritope {

/// A binary PLY whose faces have colours, all of them opaque; the legend is in its comments. The first surface's points
/// and triangles come first, in their order. REQUIRES what draw_scene requires, and fewer than 2^32 points and
/// triangles with the marks'.
/// @error kEmpty if there is nothing to show; kOverLimit for 2^32 points or triangles
Result<std::string> scene_ply(Scene scene);

/// VTK's unstructured grid of triangles, for ParaView. The cells' values are their colour with its opacity, and the
/// number of their part; the parts' names are the texts "parts" of the field data.
/// @error as scene_ply
Result<std::string> scene_vtu(Scene scene);

/// glTF 2.0 with a node for each part, whose material has the opacity. Coordinates are binary32, relative to the middle
/// of the scene's box, where a node has them.
/// @error as scene_ply; kNotFinite for a scene that is larger than binary32 or too small for it
Result<std::string> scene_gltf(Scene scene);

}  // namespace veritope
