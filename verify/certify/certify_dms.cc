// SPDX-License-Identifier: LGPL-3.0-or-later
// certify for simplex-spline solids.
#include "io/formats.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/dms_certifier.h"

namespace veritope {

Result<Certified> internal::certify_kind(const DmsFile& file, const CertifyOptions& options) {
  certificate::Subject subject;
  subject.sha256 = file.sha256;
  subject.bytes = file.bytes;
  subject.format = model_format(file.format).name;
  subject.tool = options.tool;
  return certify_dms(file.model, subject, options);
}

}  // namespace veritope
