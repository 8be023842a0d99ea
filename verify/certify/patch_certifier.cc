// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_certifier.h"

#include "robust/base/check.h"
#include "verify/certify/patch_invalid_certifier.h"
#include "verify/certify/star_box_certifier.h"

namespace veritope {

certificate::Bytes make_patch_certificate(const PatchComplex& complex,
                                          const std::optional<PieceForest>& forest,
                                          const PatchDecision& decision,
                                          const std::vector<StarBoxEntity>& entities,
                                          const certificate::Subject& subject) {
  VT_CHECK(!decision.open, "an open question has no certificate");
  if (decision.refutation) {
    if (const auto* const crossing = std::get_if<CrossingWitness>(&*decision.refutation))
      return make_patch_invalid_certificate(complex, *crossing, entities, subject);
    if (const auto* const sides = std::get_if<SideWitness>(&*decision.refutation))
      return make_patch_invalid_certificate(complex, *sides, entities, subject);
    if (const auto* const meeting = std::get_if<MeetingWitness>(&*decision.refutation))
      return make_patch_invalid_certificate(complex, *meeting, entities, subject);
  }
  return make_star_box_certificate(*forest, decision.cover, decision.walks, entities, subject);
}

}  // namespace veritope
