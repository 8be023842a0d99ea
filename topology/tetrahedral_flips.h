// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/tetrahedral_flips.h: flips of linked tetrahedra: other tetrahedra with the same boundary in the place of a
// few. Integers only: whether the new tetrahedra are positively oriented in space is the caller's question.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "topology/linked_tetrahedra.h"

namespace veritope {

/// The faces of the tetrahedra that are glued to none of them, in ascending order of the tetrahedra as given.
std::vector<TetrahedronFace> shell_of(const LinkedTetrahedra& complex,
                                      std::span<const std::uint32_t> ball);
/// The tetrahedra at an edge, in order around it, from one of them. If the edge is on the boundary: from one end to the
/// other. REQUIRES that the tetrahedron has the edge.
std::vector<std::uint32_t> tetrahedra_around(const LinkedTetrahedra& complex, std::uint32_t t,
                                             std::uint32_t a, std::uint32_t b);
/// The tetrahedra at a vertex, found from one of them through faces.
std::vector<std::uint32_t> tetrahedra_around(const LinkedTetrahedra& complex, std::uint32_t t,
                                             std::uint32_t v);

/// A new vertex in a tetrahedron: 1-4. REQUIRES that the vertex is in no tetrahedron, as do the next two.
void insert_in_tetrahedron(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t vertex);
/// In a face between two tetrahedra: 2-6; in one of the boundary: 1-3.
void insert_in_face(LinkedTetrahedra& complex, TetrahedronFace f, std::uint32_t vertex);
/// In an edge: n-2n, for an edge of the boundary, too.
void insert_in_edge(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t a, std::uint32_t b,
                    std::uint32_t vertex);

/// Why a flip was refused.
enum class FlipFault {
  kBoundary,    ///< the face or the edge is on the boundary
  kWrongCount,  ///< the edge or the vertex does not have as many tetrahedra
  kEdgeExists,  ///< the new edge or face is one of the complex already
};

/// 2-3: the two tetrahedra at a face are replaced by three at the edge between its opposite corners.
std::optional<FlipFault> flip_2_3(LinkedTetrahedra& complex, TetrahedronFace f);
/// 3-2: the inverse. REQUIRES that the tetrahedron has the edge a b, as does 4-4.
std::optional<FlipFault> flip_3_2(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t a,
                                  std::uint32_t b);
/// 4-4: the four tetrahedra at the edge a b are replaced by four at the edge from c, a corner of the first one that is
/// not on the edge, to the opposite corner of the link.
std::optional<FlipFault> flip_4_4(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t a,
                                  std::uint32_t b, std::uint32_t c);
/// 4-1, the inverse of 1-4: the vertex goes, with its four tetrahedra, which are all around it.
std::optional<FlipFault> flip_4_1(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t vertex);

}  // namespace veritope
