// SPDX-License-Identifier: LGPL-3.0-or-later
// report/report_kinds_internal.h: what each kind of model adds to the reports: one row a kind.
#pragma once
#include <cstddef>
#include <string>

#include "report/file_report.h"
#include "report/json_text.h"
#include "report/report_text.h"

namespace veritope::report::internal {

// Shells, places and the like: a soup of triangles has millions. JSON lists the first of them, texts show a few.
inline constexpr std::size_t kMostListed = 100'000, kMostShown = 8;

/// Null without a copy.
Json copy_json(const std::optional<CopyReport>& copy);

struct ReportKind {
  /// Keys between "format" and "verdict", and between "error" and "certificate".
  void (*put_source)(const FileReport& report, Json& out);
  void (*put_facts)(const FileReport& report, Json& out);
  bool has_collar;  ///< "seconds" has the key "collar"
  /// What follows the verdict and the path. REQUIRES has_verdict().
  std::string (*summary)(const FileReport& report);
  /// The lines below them, in this order: what is wrong and what helps; then what was read and measured.
  std::string (*findings)(const FileReport& report, const TextOptions& options);
  std::string (*details)(const FileReport& report, const TextOptions& options);
};

extern const ReportKind
    kMeshReports;  // mesh_json.cc, mesh_text.cc; files that could not be read, too
extern const ReportKind kPatchReports;   // patch_json.cc, patch_text.cc
extern const ReportKind kVModelReports;  // vmodel_report.cc: volumes whose cells were looked at
extern const ReportKind kMicroReports;   // micro_report.cc: microstructures
extern const ReportKind kDmsReports;     // dms_solid_report.cc: simplex-spline solids
extern const ReportKind kPlainReports;   // plain_report.cc: every other kind

/// The table: a kind of files without a row here has plain reports.
const ReportKind& kind_of(const FileReport& report);

}  // namespace veritope::report::internal
