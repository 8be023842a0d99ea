// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/patch_decision.h: whether the patches of a complex bound a solid: star boxes, walks, volumes.
// Theory: docs/THEORY.md §4, §5. Design: docs/design/0016-star-boxes.md.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "interval/interval.h"
#include "solids/base/finding.h"
#include "solids/base/verdict.h"
#include "verify/certify/cover_question.h"
#include "verify/certify/crossing_witness.h"
#include "verify/certify/meeting_witness.h"
#include "verify/certify/side_witness.h"
#include "verify/certify/star_walks.h"

namespace veritope {

struct PatchDecisionOptions {
  StarCoverOptions cover;
  OuterSides outer;  ///< which sides may be named as open, or passed in a wrong way
  /// Whether a proof of a contact may name sides and corners: no, if the checkers would have to glue more patches than
  /// they do for a file of this size (docs/certificates/patch-invalid-2.md, M1).
  bool with_contacts_on_borders = true;
  double tolerance = 1e-5;      ///< the volume's: see shell_volumes
  bool in_plain_frame = false;  ///< as collars need it: see PieceForest::Frame
  /// Boxes in frames and with several sheets where boxes along the axes would be many. REQUIRES !in_plain_frame.
  bool with_frames = false;
  /// Forests and covers are charged to it; it must outlive them. Null: no limit.
  MemoryBudget* budget = nullptr;
};

/// Why there is no proof: codes of PatchDecision::open.
namespace open_code {
inline constexpr const char* kNoSurface =
    "no-surface";  ///< S0, or another hypothesis of the theorem, does not hold
inline constexpr const char* kOutOfRange = "out-of-range";  ///< coordinates beyond binary64
inline constexpr const char* kNoStarBox =
    "no-star-box";                                      ///< not even a box of the least size exists
inline constexpr const char* kBudget = "cell-limit";    ///< more boxes than allowed
inline constexpr const char* kMemory = "memory-limit";  ///< more memory than allowed
inline constexpr const char* kNoWalk =
    "no-walk";  ///< no free path from some shell to the outside was found
/// The winding numbers beside a shell are not 1 inside and 0 outside, and the walks are not in an order that a
/// certificate could use.
inline constexpr const char* kOrientation = "orientation";
}  // namespace open_code
/// How messages about complexes that are no closed oriented surface begin; after it they say what keeps them from it.
inline constexpr const char* kNoSurfaceText =
    "the patches are not shown to be a closed oriented surface";

/// The winding number on the inner side of the shell of the last walk is not 1.
struct ReversedShell {
  std::uint32_t shell = 0;
  int winding = 0;
};
/// A proof that the patches do not bound a solid.
using PatchRefutation = std::variant<CrossingWitness, SideWitness, MeetingWitness, ReversedShell>;

struct PatchShellFacts {
  std::int64_t euler = 0, genus = 0;
  bool is_outward = true;  ///< its unbounded side is its outside
  Interval volume;
};

struct PatchDecision {
  bool is_valid = false;
  std::optional<PatchRefutation> refutation;
  /// Set iff the complex is neither valid nor refuted: why, with a code of open_code. The place may have the patch, the
  /// shell, and a box that contains the piece.
  std::optional<Finding> open;
  std::vector<PatchPart> facing;        ///< with `open`: see CoverQuestion
  std::vector<PatchShellFacts> shells;  ///< empty unless the complex is valid
  std::uint64_t bodies = 0;
  std::optional<Interval> volume;
  std::size_t boxes_tried = 0;
  /// The contents of a certificate, for a valid complex or one with a reversed shell.
  StarCover cover;
  ShellWalks walks;

  Verdict verdict() const {
    if (is_valid) return Verdict::kValid;
    return refutation ? Verdict::kInvalid : Verdict::kUndecided;
  }
};

/// Makes the forest of `complex` in *forest; the decision's node numbers refer to the forest, and the forest refers to
/// the complex.
PatchDecision decide_patches(const PatchComplex& complex, const PatchDecisionOptions& options,
                             std::optional<PieceForest>* forest);

}  // namespace veritope
