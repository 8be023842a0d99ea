// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/refutation_finding.h: what a refutation says about a model, in the file's entities, parameters and
// units.
#pragma once
#include <vector>

#include "solids/base/finding.h"
#include "verify/certify/certificate_entities.h"
#include "verify/certify/patch_decision.h"

namespace veritope {

/// Codes: "patches-crossing", "patches-touching", "side-open", "side-direction", "side-overused", "shell-turned",
/// "patch-repeated", "patch-degenerate", "singular-line". The place has the parts
/// of entities and a point near it; for a crossing, a box that contains the common point; for a reversed shell, its
/// number. REQUIRES the entities of the complex in order.
Finding finding_of(const PatchComplex& complex, const std::vector<StarBoxEntity>& entities,
                   const PatchRefutation& refutation);

}  // namespace veritope
