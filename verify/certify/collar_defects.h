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
/// pieces have no shells.
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
  /// Its one shell is a sphere, and it has one boundary component: the cells inside a flat solid are still so large
  /// that they leave nothing free.
  bool lacks_cavity = false;
};

/// The shells of each body, ascending: those of the pieces of its cells.
std::vector<std::vector<std::uint32_t>> shells_of_bodies(const PatchComplex& patches,
                                                         const PieceForest& forest,
                                                         const PieceOctree& cover,
                                                         const CommonSubdivision& complex,
                                                         const ComplexBoundary& boundary);

/// Bodies that do not hold exactly one shell, or share a shell, or do not have two boundary components with that
/// shell's Euler characteristic: such a body is no collar. Nothing is said about the others. REQUIRES K1, and that the
/// complex contains the cells of the cover.
std::vector<BodyDefect> find_body_defects(
    const PatchComplex& patches, const std::vector<std::vector<std::uint32_t>>& shells_of_body,
    const ComplexBoundary& boundary);

/// For each cell of the cover whether it is to be split. In each of the bodies, these are the cells where several
/// shells come together around a vertex or, if the body holds one shell, sheets that face in all directions; in a body
/// without such cells, all of its cells. Where these would be very many and the body lacks a cavity, they are only
/// those near the place where the sheets are farthest apart, among its finest cells.
std::vector<bool> cells_to_split(PieceForest& forest, FacingOfPieces& facing,
                                 const PieceOctree& cover, const CommonSubdivision& complex,
                                 const ComplexBoundary& boundary,
                                 const std::vector<BodyDefect>& bodies);

}  // namespace veritope
