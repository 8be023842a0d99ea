// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/root_choice_internal.h: into how many parts a patch is cut before its pieces are quartered.
// Approximate: every choice is sound.
#pragma once
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope::internal {

/// Parts along the longer parameter, so that they are approximately as long as wide.
void choose_square_roots(PieceForest::Form* form);

/// Parts along each parameter, so that a part bends along it by no more than its length along the other one, and the
/// patches beside it by no more than four times that: the rim of a thin wall is cut along its length only, and not at
/// all if it is straight and the wall flat.
/// REQUIRES the forms of all patches of a complex that is a closed oriented surface.
void choose_straight_roots(const PatchComplex& complex, std::vector<PieceForest::Form>* forms);

}  // namespace veritope::internal
