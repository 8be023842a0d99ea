// SPDX-License-Identifier: LGPL-3.0-or-later
// report/file_report.h: everything that veritope certify says about one file, before it is JSON or text: one shape for
// all kinds.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/model_file.h"
#include "report/exit_code.h"
#include "solids/base/finding.h"
#include "solids/base/verdict.h"
#include "verify/certify/certify.h"

namespace veritope::report {

/// "VALID", "INVALID", "UNDECIDED"; nothing: "UNREADABLE".
const char* verdict_word(std::optional<Verdict> verdict);

/// A certificate that was made, and whether veritope-check accepted it.
struct CertificateReport {
  std::optional<std::string> path;  ///< nothing: a temporary one
  std::string sha256;
  std::uint64_t bytes = 0;
  bool is_checked = false;  ///< false: --no-check
};

/// A model that was certified in the place of the file.
struct CopyReport {
  std::optional<std::string> path;  ///< nothing: a temporary one
  std::string sha256;
  std::uint64_t bytes = 0;
  std::string what;  ///< what of the file it has
  bool is_of_volumes = false;
  std::string format = "vjson";
};

/// The solid in whose interior a microstructure must lie.
struct InsideReport {
  std::string path, sha256, format;
  std::uint64_t bytes = 0;
};

/// Wall-clock seconds of the phases that took place.
struct PhaseSeconds {
  std::optional<double> read, decide, collar, certify, draw, check;
};

/// What was read of a spline file.
struct SplineSource {
  SplineFormat format = SplineFormat::kJson;
  std::uint64_t bytes = 0, entities = 0;
};
/// What was read of a file of a kind that reports know nothing else about.
struct PlainSource {
  std::string format;
  std::uint64_t bytes = 0;
};
/// Nothing: the file could not be read.
using Source = std::variant<std::monostate, ReadReport, SplineSource, PlainSource>;
Source source_of(const ModelFile& file);

struct FileReport {
  std::string path;                                      ///< as given
  std::optional<Verdict> verdict = Verdict::kUndecided;  ///< nothing: it could not be read
  ExitCode exit = kExitUndecided;
  std::string sha256;  ///< empty: unknown
  Source source;
  Facts facts;
  std::vector<Finding> defects;  ///< of an INVALID model: what was proved, at most --max-defects
  /// What stands in the way of a verdict, for an UNDECIDED model of patches; the first is `fault`.
  std::vector<Finding> reasons;
  std::optional<CertificateReport> certificate;
  std::optional<std::string> picture;         ///< the file with it, if one was written
  std::optional<CopyReport> copy;             ///< the model of which the certificate speaks
  std::optional<std::string> boundary_faces;  ///< as Certified::boundary_faces
  std::optional<InsideReport> inside;         ///< nothing without --model
  PhaseSeconds seconds;
  /// Why it is undecided or unreadable, or why the exit is not the verdict's. Codes: those of code_name and of certify,
  /// and "internal", "not-checked", "out-of-memory", "over-budget", "file-changed".
  std::optional<Finding> fault;

  /// VALID or INVALID.
  bool has_verdict() const { return verdict && *verdict != Verdict::kUndecided; }
};

/// The size of the file that was read; nothing if it could not be read.
std::optional<std::uint64_t> num_bytes(const FileReport& report);
/// The name of its format, "stl"; nothing likewise.
std::optional<std::string> format_name(const FileReport& report);

/// Drops the verdict with its counts, defects and certificate: no checker confirmed it.
void give_up(FileReport& report, ExitCode exit, Finding fault);
/// A file that cannot be read.
void refuse(FileReport& report, Finding fault);

/// A finding without a place in the model.
Finding fault_of(std::string code, std::string message);

}  // namespace veritope::report
