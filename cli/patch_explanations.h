// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/patch_explanations.h: what veritope explain says of the answers about patches of spline files. docs/rules/ says
// it at length.
#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "solids/polyhedron/rules.h"

namespace veritope::cli {

/// `text.id` is the code of a defect (RefutationFacts::code), or of an undecided file.
struct PatchExplanation {
  RuleText text;
  std::string_view picture;  ///< as rule_picture
};

std::span<const PatchExplanation> patch_explanations();
/// Nothing for a code that has none.
const PatchExplanation* patch_explanation(std::string_view code);

}  // namespace veritope::cli
