// SPDX-License-Identifier: LGPL-3.0-or-later
// certify for microstructures.
#include "verify/certify/certify_kinds_internal.h"

namespace veritope {

Result<Certified> internal::certify_kind(const MicroFile&, const CertifyOptions& options) {
  enter(Phase::kDeciding, options);
  Certified out;
  out.verdict = Verdict::kUndecided;
  Finding finding;
  finding.code = "not-covered";
  finding.message = "there are no certificates about microstructures yet";
  out.findings.push_back(finding);
  return out;
}

}  // namespace veritope
