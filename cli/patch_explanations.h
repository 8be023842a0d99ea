// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/patch_explanations.h: the texts of veritope explain about the answers for patches of spline files. docs/rules/
// has longer ones.
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
/// Null for a code without an explanation.
const PatchExplanation* patch_explanation(std::string_view code);

}  // namespace veritope::cli
