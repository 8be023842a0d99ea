// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/patch_collar.h: the search for a collar around the surface of a patch complex, with cells as coarse as
// possible. Theory: docs/THEORY.md §2, §3. Design: docs/design/0018-patch-collars.md. Certificate:
// docs/certificates/collar.md.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solids/base/finding.h"
#include "solids/collar/octree_root.h"
#include "topology/collar.h"
#include "verify/certify/collar_place.h"
#include "verify/certify/collar_shores.h"

namespace veritope {

struct CollarSearchOptions {
  unsigned max_level = 16;                       ///< at most OctreeKey::kMaxLevel
  std::size_t max_cells = std::size_t{1} << 21;  ///< approximately 0.8 kB each
  std::size_t memory = std::size_t{1} << 27;     ///< bytes that the nets of pieces may take
};

/// Octree cells K, a proof that each component of |K| is a product with one shell inside, and where these lie. All
/// conditions of docs/certificates/collar.md hold.
struct PatchCollar {
  OctreeRoot root;  ///< in the coordinates of the forest
  CommonSubdivision complex;
  Collar collar;
  CollarPlace place;
  std::vector<Shore> shores;  ///< beside collar.boundary.components
};

struct PatchCollarSearch {
  std::optional<PatchCollar> collar;
  std::optional<Finding>
      open;  ///< iff there is no collar: why, with a box where the search ended if that is known. Its code is
             ///< "no-collar", or open_code::kBudget or kMemory where a limit ended the search
  unsigned rounds = 0;
  std::uint64_t cells_tried = 0;  ///< sum over the rounds
  std::uint64_t most_cells = 0;   ///< of a cover, with the cells that make it a manifold
};

/// Whether a grid of binary64 numbers exists for cells around the model: the model may lie too far from the origin.
/// REQUIRES a complex without defects.
bool may_have_octree(const PatchComplex& complex);

/// Starts with 64 cells and splits where the cover is no collar. Whatever grows is charged to the forest's budget
/// before it does.
/// REQUIRES a forest in a plain frame, a complete cover and winding numbers 1 inside and 0 outside of every shell.
/// @cost near-linear in the pieces and cells, times the number of levels
PatchCollarSearch find_patch_collar(PieceForest& forest, const StarCover& cover,
                                    const CollarSearchOptions& options = {});

}  // namespace veritope
