// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/collar_certifier.h: from star boxes, walks and a collar to the bytes of a collar certificate.
#pragma once
#include <vector>

#include "verify/certify/patch_collar.h"
#include "verify/certify/star_box_certifier.h"
#include "verify/format/collar_certificate.h"

namespace veritope {

/// Whether the checkers can hold the corners of the collar's root in the least unit of the boxes. REQUIRES the collar
/// of the same forest and cover.
bool fits_certificate(const PieceForest& forest, const StarCover& cover, const PatchCollar& collar);

/// The claim "collar-1", or "collar-2" if the cover needs version 2. REQUIRES as make_star_box_certificate, the collar
/// of the same forest and cover, and that it fits_certificate.
certificate::Bytes make_collar_certificate(const PieceForest& forest, const StarCover& cover,
                                           const ShellWalks& walks, const PatchCollar& collar,
                                           const std::vector<StarBoxEntity>& entities,
                                           const certificate::Subject& subject);

}  // namespace veritope
