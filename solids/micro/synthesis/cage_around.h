// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/synthesis/cage_around.h: does a cage lie around a solid?
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "solids/micro/cage/cage_containment.h"
#include "solids/patches/patch.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// A triangle of the mesh that is not proved to lie inside of the cage.
struct CageEscape {
  std::uint32_t triangle = 0;
  /// A vertex of the triangle that is on the border of the cage or outside of it: then the mesh is not in the cage.
  std::optional<std::uint32_t> vertex;
  std::optional<VFaceNumber> face;  ///< of the cage's border, which the triangle may meet
};

/// Nothing only if all triangles lie in the open union of the cells.
/// REQUIRES a valid cage (THEORY 13), and finite coordinates.
/// @error as make_patch_complex
Result<std::optional<CageEscape>> find_escape(const VModel& cage, const TriangleMesh& mesh);

/// A patch that is not proved to lie inside of the cage.
struct PatchEscape {
  std::uint32_t patch = 0;
  /// A point of the patch that is on the border of the cage or outside of it: then the surface is not in the cage.
  std::optional<PatchPoint> point;
  std::optional<VFaceNumber> face;  ///< of the cage's border, which the patch may meet
};

/// Nothing only if all patches lie in the open union of the cells. Where hulls of control points do not show that,
/// patches are cut further, into at most some 100,000 parts in all.
/// REQUIRES a valid cage (THEORY 13), patches with positive weights.
/// @error as make_patch_complex
Result<std::optional<PatchEscape>> find_escape(const VModel& cage, std::span<const Patch> patches);

}  // namespace veritope
