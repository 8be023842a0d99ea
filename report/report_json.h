// SPDX-License-Identifier: LGPL-3.0-or-later
// report/report_json.h: reports as JSON. The schema: docs/report.schema.json.
#pragma once
#include <string>
#include <vector>

#include "report/file_report.h"

namespace veritope::report {

/// One line: the element of "files" that describes this file. Keys in the order of the schema; the
/// same bytes for every --jobs, "seconds" apart.
std::string report_json(const FileReport& report);

/// The whole document from the elements of "files".
/// @param schema  "veritope-report-1" or "veritope-info-1"
std::string document_json(const std::string& schema, const std::vector<std::string>& files);

}  // namespace veritope::report
