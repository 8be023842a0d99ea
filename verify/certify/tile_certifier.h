// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/tile_certifier.h: star boxes for a tile of a microstructure that is not star-shaped. The condition F3
// of docs/certificates/microstructure.md. Design: docs/design/0081-tiles.md.
#pragma once
#include <variant>

#include "solids/micro/micro_tile.h"
#include "verify/certify/certify.h"
#include "verify/format/star_box_certificate.h"

namespace veritope {

/// The body of star-box-2 that shows that the patches bound one solid with one shell, outward; or what is against it:
/// the code and message of certify for such a model, "several-shells", "several-bodies" or "inside-out".
/// @cost  that of certify for the patches
/// REQUIRES a tile as docs/formats/micro-files.md has it, whose range is null.
std::variant<certificate::StarBoxBody, Finding> star_boxes_of(const MicroTile& tile,
                                                              const CertifyOptions& options = {});

}  // namespace veritope
