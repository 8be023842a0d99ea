// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/cover_picture.h: star boxes, collars and the solids on both sides as files to look at.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "robust/base/result.h"
#include "solids/interval_boxes/surface_boxes.h"
#include "verify/certify/patch_collar.h"
#include "verify/certify/patch_decision.h"

namespace veritope::cli {

enum class CoverPart { kBoxes, kCollar, kOuter, kInner };
/// "boxes", "collar", "outer", "inner".
std::optional<CoverPart> cover_part_from_name(std::string_view name);

/// The bytes of a file with the ending of `path`: .vtu (boxes and cells with their numbers, shells, levels), or a mesh
/// format (boxes one by one, the surface of the cells, the surfaces of the solids). REQUIRES a valid decision; a collar
/// unless part == kBoxes; is_cover_file(path).
/// @error kNotFinite if a coordinate is no binary64 number in the units of the model
Result<std::string> cover_picture(CoverPart part, const std::string& path,
                                  const PieceForest& forest, const StarCover& cover,
                                  const PatchCollar* collar);
/// The boxes of the paper in the same formats; .vtu has kind (0 face, 1 edge, 2 vertex) and entity (of the complex:
/// patch, edge, vertex). REQUIRES is_cover_file(path).
Result<std::string> surface_boxes_picture(const std::string& path, const SurfaceCover& cover);
/// Whether the name ends in .vtu, .obj, .ply, .off or .stl.
bool is_cover_file(const std::string& path);

}  // namespace veritope::cli
