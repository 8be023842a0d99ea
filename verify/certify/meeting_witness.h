// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/meeting_witness.h: a proof that two different points of a patch complex, given by rational parameters,
// have one image; the exact test of it, conditions M1 and M2 of docs/certificates/patch-invalid-2.md; and the search
// for it in patches that occur twice or are degenerate.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/patches/patch_complex.h"
#include "verify/certify/patch_place.h"

namespace veritope {

struct MeetingWitness {
  /// What made the search look here; the proof does not depend on it.
  enum class Cause {
    kRepeatedPatch,
    kDegeneratePatch,
    kSingularLine,
    kContact
  } cause = Cause::kRepeatedPatch;
  std::array<PatchPlace, 2> places;
  friend bool operator==(const MeetingWitness&, const MeetingWitness&) = default;
};

enum class MeetingCondition {
  kM1,  ///< the places are two points of the surface
  kM2,  ///< they have one image
};
/// The first condition that does not hold; nothing: the witness is a proof. Exact. REQUIRES patches of the complex and
/// positive weights. @cost  linear in the number of patches if the first place is on the border of its patch
std::optional<MeetingCondition> broken_condition(const PatchComplex& complex,
                                                 const MeetingWitness& witness);

/// Whether the numbers are short enough for a certificate.
bool has_short_numbers(const PatchPlace& place);

/// The image of a place, or of the first one. REQUIRES positive weights.
PatchPoint point_of(const PatchComplex& complex, const PatchPlace& place);
PatchPoint point_of(const PatchComplex& complex, const MeetingWitness& witness);

/// The witness in the parameters of reversed(patch), for each patch whose flag is set.
MeetingWitness with_reversed(const PatchComplex& complex, const std::vector<bool>& is_reversed,
                             MeetingWitness witness);

/// A proof from the first patch that occurs again or is degenerate, if its image is met twice at simple parameters:
/// repeated patches always; a patch that is a curve only if lines of parameters are mapped to points; singular lines
/// only at rational parameters. Nothing for a complex with a weight that is not positive or a degree over
/// kMaxPatchDegree, of which no certificate can speak.
/// @cost  at most 50,000 patches are examined for degeneracy
std::optional<MeetingWitness> find_meeting(const PatchComplex& complex);

}  // namespace veritope
