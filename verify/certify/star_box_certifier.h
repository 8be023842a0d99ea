// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/star_box_certifier.h: from star boxes and walks to the bytes of a star-box certificate.
#pragma once
#include <vector>

#include "verify/certify/certificate_entities.h"
#include "verify/certify/star_walks.h"
#include "verify/format/star_box_certificate.h"

namespace veritope {

/// The claim "star-box-1", or "star-box-turned-1" if the winding number on the inner side of the last walk's shell is not 1.
/// REQUIRES a complete cover, a walk for every shell, winding numbers 1 inside and 0 outside on all shells or others on the last walk's, and the entities of the complex in order.
certificate::Bytes make_star_box_certificate(const PieceForest& forest, const StarCover& cover,
                                             const ShellWalks& walks,
                                             const std::vector<StarBoxEntity>& entities,
                                             const certificate::Subject& subject);

}  // namespace veritope
