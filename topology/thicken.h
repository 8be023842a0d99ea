// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/thicken.h: cells to add where octree cells touch along an edge or in a vertex only.
#pragma once
#include <vector>

#include "topology/common_subdivision.h"
#include "topology/complex_boundary.h"
#include "topology/octree_key_set.h"

namespace veritope {

/// Cells that fill the defects of K1, disjoint from K's and from each other: at a bad edge one of the two empty
/// quadrants, at a bad vertex all empty octants, as far out as the finest cell there reaches. Covers of a surface by
/// cells of mixed levels have such defects where levels change.
/// Laws: (1) empty iff boundary.is_manifold(); (2) K only grows, so what lay inside |K| stays inside. Not promised:
/// that no new defects arise (repeat; this ends, because the finest level stays and K grows) nor that a tunnel or a gap
/// stays open: ask find_collar afterwards.
/// REQUIRES boundary = analyse_boundary(complex). @cost O(size of the complex)
std::vector<OctreeKey> cells_at_defects(const CommonSubdivision& complex,
                                        const ComplexBoundary& boundary);

/// Adds cells_at_defects until K1 holds.
/// @error kOverLimit if that needs more than max_faces faces in the common subdivision.
Result<CommonSubdivision> thicken_to_manifold(
    OctreeKeySet cells, std::uint32_t max_faces = CommonSubdivision::kMaxFaces);

}  // namespace veritope
