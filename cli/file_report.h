// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/file_report.h: everything that veritope certify says about one file, before it is JSON or text.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/exit_code.h"
#include "cli/patch_report.h"
#include "io/mesh/read_mesh.h"
#include "robust/base/result.h"
#include "solids/polyhedron/validity.h"

namespace veritope::cli {

enum class FileVerdict { kValid, kInvalid, kUndecided, kUnreadable };

/// "VALID", "INVALID", "UNDECIDED", "UNREADABLE".
const char* verdict_name(FileVerdict verdict);

/// A certificate that was made, and whether veritope-check accepted it.
struct CertificateReport {
  std::optional<std::string> path;  ///< nothing: a temporary one
  std::string sha256;
  std::uint64_t bytes = 0;
  bool is_checked = false;  ///< false: --no-check
};

/// Wall-clock seconds of the phases that took place.
struct PhaseSeconds {
  std::optional<double> read, decide, certify, check;
  std::optional<double> collar;  ///< of patches, beside decide
};

/// What went wrong with a file. Code names are those of code_name, and "internal", "not-checked",
/// "out-of-memory", "over-budget", "file-changed", "not-certified", "not-covered".
struct Fault {
  std::string code;
  Place place;
  std::string message;
};

/// A listed defect, and the polygons of the file that its faces were cut from (empty if all polygons are triangles).
struct ListedDefect {
  Defect defect;
  std::vector<std::uint32_t> polygons;
};

struct FileReport {
  std::string path;  ///< as given
  FileVerdict verdict = FileVerdict::kUndecided;
  ExitCode exit = kExitUndecided;
  bool as_indexed = false;
  std::string sha256;                      ///< empty: unknown
  std::optional<ReadReport> reading;       ///< nothing: unreadable
  std::optional<ValidityReport> decision;  ///< without its defects, see `defects`
  std::vector<ListedDefect> defects;       ///< at most --max-defects
  std::optional<PatchReport>
      patches;  ///< of a spline file that was read; then there is no reading, decision or defect
  std::optional<CertificateReport> certificate;
  std::string picture;  ///< PLY; empty: none was asked for, or there is no verdict
  PhaseSeconds seconds;
  std::optional<Fault>
      fault;  ///< why it is undecided, unreadable, or why the exit is not the verdict's
};

Fault fault_of(const Error& error);

/// "line 12: <message>": without the file.
std::string fault_text(const Fault& fault);

/// The first `most` of the defects, shared out among the rules: one of each broken rule, then a second
/// one of each, and so on; sorted by rule as before.
std::vector<Defect> share_out(std::vector<Defect> defects, std::size_t most);

/// How many defects there are; nothing if that was not decided.
std::optional<std::uint64_t> total_defects(const FileReport& report);

}  // namespace veritope::cli
