// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/reason_explanations.h: the verdicts without an answer, and every reason and error code that a JSON report can
// hold. docs/rules/reasons.md has these texts, too; tests/cli/reason_codes_test.py compares both with each other and
// with the codes that the sources report.
#pragma once
#include <span>
#include <string_view>

namespace veritope::cli {

/// What a person needs to know about a code.
struct ReasonText {
  std::string_view code;     ///< as in the report, in lower case
  std::string_view name;     ///< "number that is not finite"
  std::string_view meaning;  ///< what happened, and with which exit status
  std::string_view causes;   ///< where it usually comes from
  std::string_view remedy;   ///< what usually helps
};

/// Verdicts first, then refused inputs, then proofs that were not found or not confirmed, then critical points left
/// open.
std::span<const ReasonText> reason_texts();
/// Null for a code without a page. Letters of either case are equal, because reports print verdicts in capitals.
const ReasonText* reason_text(std::string_view code);

}  // namespace veritope::cli
