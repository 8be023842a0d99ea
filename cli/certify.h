// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/certify.h: one file: read, decide, certify, check by another process, keep the certificate.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "cli/file_report.h"
#include "cli/progress.h"
#include "io/read_model.h"
#include "solids/patches/patch_complex.h"

namespace veritope::cli {

struct CertifySettings {
  ModelReadOptions reading;
  PatchOrientation orientation = PatchOrientation::kKeep;
  bool with_collar = false;         ///< of a spline file: collar-1 if there is a collar
  std::optional<double> tolerance;  ///< of the volume of a spline file: see PatchDecisionOptions
  unsigned jobs = 1;
  std::size_t max_defects = 20;
  std::string checker;  ///< its program; empty: --no-check
  bool with_picture = false;
};

/// Keeps the bytes of a certificate that was accepted and returns the name of the file. @error kCannotWrite
using KeepCertificate = std::function<Result<std::string>(std::string_view bytes)>;

/// @param path  a file, or "-" for standard input
/// @param keep  called once, last, if there is a verdict; empty: the certificate is not kept
/// Never throws for a reason that lies in the file; an internal error becomes exit 5 with the words to report it.
FileReport certify_file(const std::string& path, const CertifySettings& settings,
                        const KeepCertificate& keep, Progress& progress);

/// "veritope 0.1.0": the tool of reports and certificates.
std::string tool_name();

}  // namespace veritope::cli
