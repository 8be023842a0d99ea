// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/patch_certifier.h: from a decided patch complex to its certificate, whatever the decision is.
#pragma once
#include <optional>
#include <vector>

#include "verify/certify/certificate_entities.h"
#include "verify/certify/patch_decision.h"
#include "verify/format/mesh_certificate.h"

namespace veritope {

/// The claim star-box of a valid complex, patch-invalid or star-box-turned of a refuted one, in the least version that
/// can make it.
/// REQUIRES a decision of `complex` that is not open, the forest that it was made with, and the entities of the complex
/// in order.
certificate::Bytes make_patch_certificate(const PatchComplex& complex,
                                          const std::optional<PieceForest>& forest,
                                          const PatchDecision& decision,
                                          const std::vector<StarBoxEntity>& entities,
                                          const certificate::Subject& subject);

}  // namespace veritope
