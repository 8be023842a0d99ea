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
#include "robust/base/verdict.h"
#include "robust/finding.h"
#include "verify/certify/crossing_witness.h"
#include "verify/certify/side_witness.h"
#include "verify/certify/star_walks.h"

namespace veritope {

struct PatchDecisionOptions {
  StarCoverOptions cover;
  OuterSides outer;             ///< which sides may be named as open, or passed in a wrong way
  double tolerance = 1e-5;      ///< of the volume: see shell_volumes
  bool in_plain_frame = false;  ///< as collars need it: see PieceForest::Frame
};

/// Why there is no proof: codes of PatchDecision::open.
namespace open_code {
inline constexpr const char* kNoSurface =
    "no-surface";  ///< S0 does not hold, or what the theorem needs besides
inline constexpr const char* kOutOfRange = "out-of-range";  ///< coordinates beyond binary64
inline constexpr const char* kNoStarBox = "no-star-box";    ///< not even of the least size tried
inline constexpr const char* kBudget = "box-budget";        ///< too many boxes
inline constexpr const char* kNoWalk = "no-walk";  ///< from a shell no free path outwards was found
/// The winding numbers beside a shell are not 1 inside and 0 outside, and the walks have no order that a certificate
/// needs.
inline constexpr const char* kOrientation = "orientation";
}  // namespace open_code

/// The winding number on the inner side of the shell of the last walk is not 1.
struct TurnedShell {
  std::uint32_t shell = 0;
  int winding = 0;
};
/// A proof that the patches do not bound a solid.
using PatchRefutation = std::variant<CrossingWitness, SideWitness, TurnedShell>;

struct PatchShellFacts {
  std::int64_t euler = 0, genus = 0;
  bool is_outward = true;  ///< its unbounded side is its outside
  Interval volume;
};

struct PatchDecision {
  bool is_valid = false;
  std::optional<PatchRefutation> refutation;
  /// Iff neither: why, with a code of open_code. The place may have the patch, the shell, and a box that contains the
  /// piece.
  std::optional<Finding> open;
  std::vector<PatchShellFacts> shells;  ///< of a valid complex
  std::uint64_t bodies = 0;
  std::optional<Interval> volume;
  std::size_t boxes_tried = 0;
  /// What a certificate is made of, of a valid complex or one with a turned shell.
  StarCover cover;
  ShellWalks walks;

  Verdict verdict() const {
    if (is_valid) return Verdict::kValid;
    return refutation ? Verdict::kInvalid : Verdict::kUndecided;
  }
};

/// The forest of `complex` is made in *forest, where the decision's node numbers point to; it refers to the complex.
PatchDecision decide_patches(const PatchComplex& complex, const PatchDecisionOptions& options,
                             std::optional<PieceForest>* forest);

}  // namespace veritope
