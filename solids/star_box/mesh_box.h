// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/mesh_box.h: boxes in which flat patches meet as their abstract faces do: for vertices whose normals
// lie in no open half-space. Theory: docs/THEORY.md §4, STAR-6. The conditions: docs/certificates/star-box.md and
// star-box-2.md, section 5.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "solids/pieces/piece_forest.h"
#include "solids/star_box/flat_patch.h"

namespace veritope {

/// The patches that meet the closed box, if all of them are among the flat ones, and any two of their triangles (a flat
/// tensor patch is two, cut along the diagonal from its corner 0) meet exactly in their common vertex or edge of X, or
/// not at all if they have no vertex in common. They are taken whole, however long and thin they are. The result is
/// empty in all other cases: also if more than `most` triangles meet the box, if one has no normal, or if a patch that
/// is not flat cannot be shown to miss the box. Box in the forest's coordinates.
/// @cost for a pair of triangles: some 20 separating axes in intervals, in rationals where intervals do not decide
std::optional<std::vector<std::uint32_t>> mesh_box_patches(PieceForest& forest, FlatPatches& flat,
                                                           const Box3d& box, std::size_t most);

}  // namespace veritope
