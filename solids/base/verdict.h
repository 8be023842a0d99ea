// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/base/verdict.h: the answer to the question whether a model bounds a solid.
#pragma once

namespace veritope {

/// VALID and INVALID are proved. A file that cannot be read has no verdict: its reader returns an Error.
enum class Verdict {
  kValid,
  kInvalid,
  kUndecided,  ///< not proved within the budget, or nothing that a certificate can speak of; a Finding names the place
};

/// "VALID", "INVALID", "UNDECIDED".
constexpr const char* verdict_name(Verdict verdict) {
  if (verdict == Verdict::kValid) return "VALID";
  return verdict == Verdict::kInvalid ? "INVALID" : "UNDECIDED";
}

}  // namespace veritope
