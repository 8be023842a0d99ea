// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/dms_truth_judge.h: what certify says of solids whose verdict is known.
#pragma once
#include <string>

#include "io/dms/write_dms.h"
#include "tests/support/dms_truth.h"
#include "verify/certify/dms_certifier.h"
#include "verify/format/sha256.h"

namespace veritope::dms_truth {

/// Names the bytes of the model's canonical file.
inline Certified certified(const DmsModel& model) {
  const std::string bytes = write_dms(model);
  certificate::Subject subject;
  subject.sha256 =
      to_hex(sha256({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}));
  subject.bytes = bytes.size();
  subject.format = "vdms";
  CertifyOptions options;
  subject.tool = options.tool;
  return certify_dms(model, subject, options);
}

enum class Judgement { kRight, kUndecided, kWrong };
/// Whether the verdict is that of the case, and the first defect has its code.
inline Judgement judge(const Case& drawn, const Certified& said) {
  if (said.verdict == Verdict::kUndecided)
    return drawn.truth == Truth::kNotInvalid ? Judgement::kRight : Judgement::kUndecided;
  const bool is_valid = said.verdict == Verdict::kValid;
  if (is_valid != (drawn.truth == Truth::kValid)) return Judgement::kWrong;
  const bool has_code = is_valid || drawn.code.empty() || said.findings[0].code == drawn.code;
  return has_code ? Judgement::kRight : Judgement::kWrong;
}
inline std::string said_of(const Certified& said) {
  return said.findings.empty() ? "valid" : said.findings[0].code + ": " + said.findings[0].message;
}

}  // namespace veritope::dms_truth
