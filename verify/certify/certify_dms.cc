// SPDX-License-Identifier: LGPL-3.0-or-later
// certify for simplex-spline solids: no claim about them exists yet, so there is no verdict.
#include "solids/dms/dms_defects.h"
#include "verify/certify/certify_kinds_internal.h"

namespace veritope {

Result<Certified> internal::certify_kind(const DmsFile& file, const CertifyOptions&) {
  Certified out;
  Finding finding;
  finding.code = "not-certified";
  finding.message = "no certificate can state yet that a simplex-spline solid is valid";
  if (const DmsDefects defects = find_dms_defects(file.model, 1); defects.count > 0)
    finding.message = "no certificate can state it yet, but the model has " +
                      std::to_string(defects.count) +
                      " defects; the first one: " + to_string(defects.first[0]);
  out.findings.push_back(std::move(finding));
  return out;
}

}  // namespace veritope
