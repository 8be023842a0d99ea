// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/certification.h: one run of certify on one file: read, certify, have another process check, keep the certificate.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "cli/progress.h"
#include "io/read_model.h"
#include "report/file_report.h"
#include "verify/certify/certify.h"

namespace veritope::cli {

using namespace report;

struct CertifySettings {
  ModelReadOptions reading;
  CertifyOptions certify;  ///< on_phase is set here
  std::string checker;     ///< the checker's program; empty: --no-check
  bool with_picture = false;
};

struct KeptFiles {
  std::string certificate;
  std::optional<std::string> copy;
};
/// Keeps the bytes of a certificate that was accepted, and of the copy that was certified if there is one, and returns
/// the names of the files; nothing for a copy that has no place. @error kCannotWrite
using KeepCertificate = std::function<Result<KeptFiles>(std::string_view certificate,
                                                        std::optional<std::string_view> copy)>;

struct CertifiedFile {
  report::FileReport report;
  std::string picture;  ///< PLY; empty: not requested, no verdict, or not a mesh
};

/// @param path  a file, or "-" for standard input
/// @param keep  called once, last, if there is a verdict; empty: the certificate is not kept
/// Never throws because of the file's content; an internal error becomes exit 5 with the words to report it.
CertifiedFile certify_file(const std::string& path, const CertifySettings& settings,
                           const KeepCertificate& keep, Progress& progress);

}  // namespace veritope::cli
