// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/separating_axis.h: an axis that separates two facets, found and proved in binary64.
// Bound: docs/bounds/separating_axis.md.
#pragma once
#include <cstdint>
#include <optional>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

namespace internal {
// The first axis separates by more than kAxisRel * size^3, the others by kAxisCubicRel * size^4.
inline constexpr double kAxisRel = 0x1.08p-44, kAxisCubicRel = 0x1.68p-42;
inline constexpr double kAxisLeastSize = 0x1p-150, kAxisMostSize = 0x1p150;
}  // namespace internal

/// The code byte (an axis, and 32 for the opposite direction) of the first axis, in the order of docs/certificates/mesh.md section 5, that certainly separates the
/// facets: d.p < d.q for all corners p of a, q of b, exactly. Nothing if none does so certainly, or if the facets have a
/// common vertex.
/// @cost approximately 50 ns
std::optional<std::uint8_t> separating_axis(const TriangleMesh& mesh, std::uint32_t a,
                                            std::uint32_t b);

}  // namespace veritope
