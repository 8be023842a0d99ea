// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/report_json.h: reports as JSON. The schema: docs/report.schema.json.
#pragma once
#include <string>
#include <vector>

#include "cli/file_report.h"

namespace veritope::cli {

/// One line: the element of "files" that describes this file. Keys in the order of the schema; the
/// same bytes for every --jobs, "seconds" apart.
std::string report_json(const FileReport& report);

/// What veritope info says about a file.
struct InfoReport {
  std::string path;
  ExitCode exit = kExitValid;
  bool as_indexed = false;
  std::optional<MeshFile> file;       ///< nothing: unreadable
  std::vector<std::string> lossless;  ///< variants that hold it without loss
  bool holds_everywhere = false;      ///< those are all variants
  std::optional<Fault> fault;
};
std::string info_json(const InfoReport& report);

/// The whole document from the elements of "files".
/// @param schema  "veritope-report-1" or "veritope-info-1"
std::string document_json(const std::string& schema, const std::vector<std::string>& files);

}  // namespace veritope::cli
