// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/collar_place.h: proves that the surface lies inside a union of octree cells, shell by shell. Theory:
// docs/THEORY.md §3.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solids/collar/octree_root.h"
#include "topology/complex_boundary.h"
#include "verify/certify/star_cover.h"

namespace veritope {

/// Conditions I1 and I2 of docs/certificates/collar.md.
struct CollarPlace {
  /// Marks the nodes that end the trees below the leaves of the star cover. Between such a leaf and a node of the
  /// forest without children lies exactly one of them.
  std::vector<bool> is_leaf;
  std::size_t num_leaves = 0;
  std::vector<std::uint32_t> body_of_shell;
};

/// The place where I1 or I2 does not hold, or cannot be shown.
struct Misplaced {
  PieceForest::Id piece =
      PieceForest::kNone;  ///< the node whose hull is not inside; kNone: a shell is not alone in one body
  std::string message;
};

/// Splits the leaves of the cover until inside(root) holds for the hull of each piece, into as few pieces as that
/// allows. REQUIRES a complete cover, boundary = analyse_boundary(complex), K1.
/// @cost O(pieces depth), bounded by the work that checkers do
std::optional<CollarPlace> place_surface(PieceForest& forest, const StarCover& cover,
                                         const OctreeRoot& root, const CommonSubdivision& complex,
                                         const ComplexBoundary& boundary, Misplaced* why);

}  // namespace veritope
