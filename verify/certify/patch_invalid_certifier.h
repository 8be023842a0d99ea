// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/patch_invalid_certifier.h: from a witness to the bytes of a patch-invalid certificate.
#pragma once
#include <variant>
#include <vector>

#include "verify/certify/certificate_entities.h"
#include "verify/certify/crossing_witness.h"
#include "verify/certify/meeting_witness.h"
#include "verify/certify/side_witness.h"
#include "verify/format/patch_invalid_certificate.h"
#include "verify/format/patch_meeting_certificate.h"

namespace veritope {

using PatchInvalidWitness = std::variant<CrossingWitness, SideWitness, MeetingWitness>;

/// The claim patch-invalid-1 of a crossing or of sides, patch-invalid-2 of a meeting. The certificate uses the
/// parameters of the file. The witness is tested once more; a witness that proves nothing is
/// an internal error. REQUIRES the entities of the complex in order.
certificate::Bytes make_patch_invalid_certificate(const PatchComplex& complex,
                                                  const PatchInvalidWitness& witness,
                                                  const std::vector<StarBoxEntity>& entities,
                                                  const certificate::Subject& subject);

}  // namespace veritope
