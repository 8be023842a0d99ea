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

namespace veritope {

/// A point of the tensor form of a patch (tensor_form in crossing_witness.h): (u, v), or (s, t) of a triangle.
struct PatchPlace {
  std::uint32_t patch = 0;
  std::array<Rational, 2> at;
  friend bool operator==(const PatchPlace&, const PatchPlace&) = default;
};

struct MeetingWitness {
  /// What made the search look here; the proof does not depend on it.
  enum class Cause {
    kRepeatedPatch,
    kDegeneratePatch,
    kSingularLine
  } cause = Cause::kRepeatedPatch;
  std::array<PatchPlace, 2> places;
  friend bool operator==(const MeetingWitness&, const MeetingWitness&) = default;
};

enum class MeetingCondition {
  kM1,  ///< the places are two points of the surface, the first in the open domain of its patch
  kM2,  ///< they have one image
};
/// The first condition that does not hold; nothing: the witness is a proof. Exact. REQUIRES patches of the complex and
/// positive weights.
std::optional<MeetingCondition> broken_condition(const PatchComplex& complex,
                                                 const MeetingWitness& witness);

/// The image of the first place. REQUIRES positive weights.
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
