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
#include "verify/certify/crossing_witness.h"
#include "verify/certify/side_witness.h"
#include "verify/certify/star_walks.h"

namespace veritope {

struct PatchDecisionOptions {
  StarCoverOptions cover;
  OuterSides outer;         ///< which sides may be named as open, or passed in a wrong way
  double tolerance = 1e-5;  ///< of the volume: see shell_volumes
  bool in_plain_frame = false;  ///< as collars need it: see PieceForest::Frame
};

/// Where and why there is no proof.
struct OpenQuestion {
  enum class Kind {
    kComplex,     ///< the complex has findings: S0 does not hold, or what the theorem needs besides
    kOutOfRange,  ///< coordinates beyond binary64
    kNoStarBox,   ///< no star box of the least size tried
    kBudget,      ///< too many boxes
    kNoWalk,      ///< from a shell no free path outwards was found
    kOrientation,  ///< the winding numbers beside a shell are not 1 inside and 0 outside, and the walks have no order that a certificate needs
  };
  Kind kind;
  std::optional<std::uint32_t> patch, shell;
  std::optional<Box3d> place;  ///< in the model's units, rounded outward; contains the piece
  std::string message;
};

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
  std::optional<OpenQuestion> open;     ///< iff neither
  std::vector<PatchShellFacts> shells;  ///< of a valid complex
  std::uint64_t bodies = 0;
  std::optional<Interval> volume;
  std::size_t boxes_tried = 0;
  /// What a certificate is made of, of a valid complex or one with a turned shell.
  StarCover cover;
  ShellWalks walks;
};

/// The forest of `complex` is made in *forest, where the decision's node numbers point to; it refers to the complex.
PatchDecision decide_patches(const PatchComplex& complex, const PatchDecisionOptions& options,
                             std::optional<PieceForest>* forest);

}  // namespace veritope
