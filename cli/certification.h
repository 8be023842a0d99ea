// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/certification.h: one run of certify on one file: read, certify, have another process check, keep the certificate.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "cli/model_picture.h"
#include "cli/progress.h"
#include "io/read_model.h"
#include "report/file_report.h"
#include "verify/certify/certify.h"

namespace veritope::cli {

using namespace report;

/// --model of microstructures: the solid, read once.
struct InsideModelFile {
  ModelFile file;  ///< a mesh, or splines
  InsideReport report;
};

struct CertifySettings {
  ModelReadOptions reading;
  CertifyOptions certify;  ///< on_phase and work are set here
  bool spares_threads =
      false;  ///< one thread for meshes so small that starting others takes longer than they save
  std::string checker;  ///< the checker's program; empty: --no-check
  /// Nothing: no picture. A picture shows up to kMostDrawn defects of each rule, whatever the number that is listed.
  std::optional<PictureKind> picture;
  const InsideModelFile* inside = nullptr;  ///< null: without --model
  /// Not null: takes the model once it is decided, or has turned out to be undecided.
  ModelFile* model = nullptr;
  /// Not null: takes the bytes of an input that needs_copy.
  std::string* model_bytes = nullptr;
};

/// Whether the input's name means another file in another process, or one that can be read once only.
bool needs_copy(const std::string& path);

/// The model that was certified in the place of the file.
struct StandInBytes {
  std::string format;
  std::string bytes;
};
struct KeptFiles {
  std::string certificate;
  std::optional<std::string> copy;
};
/// Keeps the bytes of a certificate that was accepted, and of the copy that was certified unless it is null. Returns
/// the names of the files; nothing for a copy that has no place. @error kCannotWrite
using KeepCertificate =
    std::function<Result<KeptFiles>(std::string_view certificate, const StandInBytes* copy)>;

struct CertifiedFile {
  report::FileReport report;
  std::string picture;  ///< its bytes; empty: not requested, no verdict, or it could not be drawn
  std::optional<Finding> picture_fault;  ///< why it could not be drawn
};

/// @param path  a file, or "-" for standard input
/// @param keep  called once, last, if there is a verdict; empty: the certificate is not kept
/// Never throws because of the file's content; an internal error becomes exit 5 with the words to report it.
CertifiedFile certify_file(const std::string& path, const CertifySettings& settings,
                           const KeepCertificate& keep, Progress& progress);

}  // namespace veritope::cli
