// SPDX-License-Identifier: LGPL-3.0-or-later
// certify for microstructures.
#include "io/formats.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/micro_certifier.h"
#include "verify/certify/micro_inside_certifier.h"

namespace veritope {
namespace {

Certified uncovered(const MicroFile& file) {
  Certified out;
  out.facts = micro_facts_of(file.micro);
  out.findings.push_back(finding_of(*file.beyond_default_limits));
  out.findings.back().code = "not-covered";
  return out;
}

}  // namespace

Result<Certified> internal::certify_kind(const MicroFile& file, const CertifyOptions& options) {
  if (file.beyond_default_limits) return uncovered(file);
  certificate::Subject subject;
  subject.sha256 = file.sha256;
  subject.bytes = file.bytes;
  subject.format = model_format(file.format).name;
  subject.tool = options.tool;
  if (options.inside != nullptr)
    return certify_inside(file.micro, subject, *options.inside, options);
  return certify_microstructure(file.micro, subject, options);
}

}  // namespace veritope
