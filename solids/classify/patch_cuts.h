// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/patch_cuts.h: the surface of a complex as many parts of patches.
#pragma once
#include <cstddef>
#include <vector>

#include "solids/classify/patch_piece.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// Parts whose union is the surface: the patches, of which the largest is halved until there are `about` so many.
/// REQUIRES positive weights, and a live ScopedUpward.
std::vector<PatchPiece> pieces_of(const PatchComplex& complex, std::size_t about);

}  // namespace veritope
