// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/walk_boxes.h: boxes at which walks can start and end, for covers whose boxes hold several sheets.
// Theory: docs/THEORY.md §5.
#pragma once
#include "verify/certify/frame_search.h"
#include "verify/certify/star_cover.h"

namespace veritope {

/// Walks start and end at star boxes with one sheet. Where there are boxes with several, each shell gets a small one at
/// the place where it reaches farthest along x, and the next shell on the half-line from there along x gets one, too,
/// where the half-line meets it: a straight walk between them is short. Shells that have no walk then get others: where
/// they reach farthest in the other five directions, and inside patches there. A shell that mesh boxes cover alone gets
/// one. REQUIRES a complete cover with one leaf on every way down, which it stays.
void add_boxes_for_walks(PieceForest& forest, FrameSearch& frames, StarCover* cover);

}  // namespace veritope
