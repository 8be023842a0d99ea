// SPDX-License-Identifier: LGPL-3.0-or-later
// hard_models/hard_patches.h: models of patches that are hard to decide, whose answers are known by construction.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "solids/patches/patch.h"

namespace veritope::hard_models {

/// What `veritope certify` answers; tests/cli/hard_models_test.py compares.
enum class Answer {
  kProved,     ///< the truth, with a certificate
  kUndecided,  ///< UNDECIDED: the truth is known by construction only
};

/// Patches and whether they bound a solid: in space, as a set of points with a side.
struct HardPatches {
  std::string name;  ///< letters, digits and underscores
  std::string what;  ///< one sentence
  std::vector<Patch> patches;
  bool is_valid = true;
  Answer answer = Answer::kProved;
  std::string
      code;  ///< of the finding that is proved, or of the reason for UNDECIDED; empty: VALID
  int bodies = 0, genus = 0;  ///< of a valid model
};

/// Sides that are open by one ulp, T-junctions, contacts and crossings by 1e-12, thin walls along the axes and oblique,
/// poles, turned shells, repeated and degenerate patches, and sound solids of many shapes.
std::vector<HardPatches> plain_hard_patches();

/// Those, and NAME_shuffled of each that has at most twelve patches: the patches in another order, with other corners
/// first, as `seed` selects.
std::vector<HardPatches> hard_patches(std::uint64_t seed);

}  // namespace veritope::hard_models
