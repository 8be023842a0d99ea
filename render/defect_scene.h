// SPDX-License-Identifier: LGPL-3.0-or-later
// render/defect_scene.h: scenes that show where a model is wrong. draw_scene makes pictures of them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/splines/boundary_faces.h"
#include "io/splines/spline_model.h"
#include "render/scene.h"
#include "robust/base/result.h"
#include "solids/base/finding.h"
#include "solids/polyhedron/rules.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// Grey; half transparent if there is something to be seen through it.
Paint model_paint(bool is_sound);
/// Half transparent; fainter than marks of that colour.
Paint tinted_paint(Colour colour);

/// The mesh half transparent, the faces of each defect (of M8 and M9 those of the whole shell) tinted with the colour
/// of its rule, and in that colour the defect itself: the edges of M3, M4 and M5 and the segments of M7 as lines, and
/// points as markers. Lines that are connected and all of which lie within a tenth of the model's size have a marker,
/// too, so that nothing is too small to be seen. Marks of rare rules are in front of those of frequent ones. The legend
/// has the rules that are broken, with their counts.
/// REQUIRES defects of this mesh, as list_defects lists them; a positive count for each rule that they break.
/// @cost O(faces + n log n) for n defects
Scene defect_scene(const TriangleMesh& mesh, std::span<const Finding> defects,
                   const std::array<std::uint64_t, kNumMeshRules>& rule_counts);

/// The tessellated model half transparent, the entities of each finding tinted, open sides as lines, and a marker at
/// the point of each finding. If one is a crossing, the approximate curves in which surfaces cross are lines, too:
/// those of all surfaces (approx_crossings). The legend has the codes of the findings, the number of pairs that cross
/// if it is not 1, and the number of open sides if there is one.
/// REQUIRES findings and sides of this model: their entities, sides and parameters.
/// @param  shown  drawn in the place of the model's volumes: their boundary faces, without walls
/// @error  as tessellate
Result<Scene> defect_scene(const SplineModel& model, std::span<const Finding> findings,
                           std::span<const EntityPart> open_sides, std::uint64_t num_open_sides,
                           const BoundaryFaces* shown = nullptr);

}  // namespace veritope
