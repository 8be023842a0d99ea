// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/collar_defects.h: which bodies of a cover are no collars of one shell each, and which of their cells
// to split. Theory: docs/THEORY.md §2, §3.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "solids/collar/facing.h"
#include "solids/collar/piece_octree.h"
#include "topology/complex_boundary.h"

namespace veritope {

/// The shells that the pieces of a cell, or of the cells around a vertex, belong to, and how they face. Cells without
/// pieces have none.
struct LocalSheets {
  Facing facing = kAllDirections;
  std::uint32_t least_shell = ~std::uint32_t{0}, greatest_shell = 0;

  bool is_suspicious() const { return facing == 0 || least_shell < greatest_shell; }
  void add(const LocalSheets& other);
};

struct BodyDefect {
  std::uint32_t body = 0;
  bool has_one_shell = true;
  std::string message;
};

/// The shells of each body, ascending: those of the pieces of its cells.
std::vector<std::vector<std::uint32_t>> shells_of_bodies(const PatchComplex& patches,
                                                         const PieceForest& forest,
                                                         const PieceOctree& cover,
                                                         const CommonSubdivision& complex,
                                                         const ComplexBoundary& boundary);

/// Bodies that hold not exactly one shell, or share one, or have not two boundary components with its Euler
/// characteristic: none of them is a collar. Nothing is said about the others. REQUIRES K1, and that the complex
/// contains the cells of the cover.
std::vector<BodyDefect> find_body_defects(
    const PatchComplex& patches, const std::vector<std::vector<std::uint32_t>>& shells_of_body,
    const ComplexBoundary& boundary);

/// For each cell of the cover whether it is to be split: those of the bodies where several shells come together around
/// a vertex, or in a body of one shell sheets that face in all directions; all cells of a body without such cells.
std::vector<bool> cells_to_split(PieceForest& forest, FacingOfPieces& facing,
                                 const PieceOctree& cover, const CommonSubdivision& complex,
                                 const ComplexBoundary& boundary,
                                 const std::vector<BodyDefect>& bodies);

}  // namespace veritope
