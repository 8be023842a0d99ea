// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/vertex_star.h: directions along which the facets at a vertex turn around it exactly once.
// Theory: docs/THEORY.md, fan lemma.  Certificate: docs/certificates/mesh.md section 4.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "solids/polyhedron/facet_signs.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "topology/incidence.h"

namespace veritope {

/// A direction with small integer components.
using IntVec3 = std::array<std::int32_t, 3>;

/// Directions 1..13 of the certificate format; entry 0 is unused.
inline constexpr std::array<IntVec3, 14> kStarDirections{{{0, 0, 0},  {1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                                          {1, 1, 0},  {1, -1, 0}, {1, 0, 1},  {1, 0, -1},
                                                          {0, 1, 1},  {0, 1, -1}, {1, 1, 1},  {1, 1, -1},
                                                          {1, -1, 1}, {1, -1, -1}}};
inline constexpr std::uint8_t kNoStar = 0;
inline constexpr std::uint8_t kOwnDirection = 14;

/// If vertex v has code[v] != kNoStar, then along its direction d every facet at v has n.d of one sign, not zero, and
/// the facets turn around v exactly once; hence any two facets that share v meet exactly in their common simplex. The
/// converse does not hold: kNoStar says nothing.
struct VertexStars {
  std::vector<std::uint8_t> code;                            ///< one for each vertex
  std::vector<std::pair<std::uint32_t, IntVec3>> own;        ///< for code kOwnDirection, by ascending vertex
  bool operator[](std::uint32_t v) const { return code[v] != kNoStar; }
};

/// Looks for a direction at every vertex but those of `irregular` (ascending), which must contain all vertices whose
/// facets are not one closed, oriented fan (the lemma needs the fan). The result does not depend on jobs. @cost O(F).
VertexStars find_vertex_stars(const TriangleMesh& mesh, const Incidence& incidence, const FacetSigns& signs,
                              std::span<const std::uint32_t> irregular, unsigned jobs);

}  // namespace veritope
