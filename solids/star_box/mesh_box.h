// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/mesh_box.h: boxes in which flat triangles meet as their abstract faces do: for vertices whose normals
// lie in no open half-space. Theory: docs/THEORY.md §4. The conditions: docs/certificates/star-box.md, section 5.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope {

/// The patches that meet the closed box, if all of them are polynomial triangles of degree 1 with normals that are not
/// 0, and any two of them meet exactly in their common vertex or edge of X, or not at all if they have no vertex in
/// common. Nothing otherwise, or if more than `most` patches meet the box, or if a patch that is no such triangle
/// cannot be shown to miss the box. Box in the forest's coordinates.
/// @cost for a pair of triangles: some 20 separating axes in intervals, in rationals where intervals do not decide
std::optional<std::vector<std::uint32_t>> mesh_box_triangles(PieceForest& forest, const Box3d& box,
                                                             std::size_t most);

}  // namespace veritope
