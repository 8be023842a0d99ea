// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/certify.h"

#include "verify/certify/certify_kinds_internal.h"

namespace veritope {

std::string tool_name() { return "veritope " VERITOPE_VERSION; }

Result<Certified> certify(const ModelFile& file, const CertifyOptions& options) {
  return std::visit([&](const auto& kind) { return internal::certify_kind(kind, options); }, file);
}

}  // namespace veritope
