// SPDX-License-Identifier: LGPL-3.0-or-later
// report/mesh_report_internal.h: the parts of reports about meshes.
#pragma once
#include <cstdint>
#include <string>

#include "report/report_kinds_internal.h"

namespace veritope::report::internal {

/// Null: the file is unreadable, or there is no verdict.
const ReadReport* reading_of(const FileReport& report);
const ValidityReport* decision_of(const FileReport& report);
/// Null, too, if they were not measured.
const OpenEdges* open_edges_of(const FileReport& report);
/// Null, too, if no faces were reversed.
const Reversal* reversal_of(const FileReport& report);

Json ignored_json(const ReadReport* reading);
Json notices_json(const ReadReport* reading);

std::string mesh_summary(const FileReport& report);
std::string mesh_findings(const FileReport& report, const TextOptions& options);
std::string mesh_details(const FileReport& report, const TextOptions& options);

// Lines of text that veritope info has, too.
std::string file_text(const ReadReport& reading);
std::string vertices_text(const ReadReport& reading);
std::string ignored_text(const ReadReport& reading);
std::string notices_text(const ReadReport& reading);
std::string box_text(const Box3d& box);

}  // namespace veritope::report::internal
