// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/certify_kinds_internal.h: the kinds of models that certify knows: one overload a kind, each in a file
// of its own.
#pragma once
#include "verify/certify/certify.h"

namespace veritope::internal {

// As certify, for one kind. A new alternative of ModelFile needs an overload here, with a body in a file of its own,
// certify_KIND.cc: without it certify.cc does not compile.
Result<Certified> certify_kind(const MeshFile& file, const CertifyOptions& options);
Result<Certified> certify_kind(const SplineFile& file, const CertifyOptions& options);
Result<Certified> certify_kind(const MicroFile& file, const CertifyOptions& options);
Result<Certified> certify_kind(const DmsFile& file, const CertifyOptions& options);

inline void enter(Phase phase, const CertifyOptions& options) {
  if (options.on_phase) options.on_phase(phase);
}

}  // namespace veritope::internal
