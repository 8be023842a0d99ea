// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/patch_report.h: what veritope certify says about the patches of a spline file, beside the verdict.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/spline_format.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/refutation_facts.h"

namespace veritope::cli {

struct PatchReport {
  SplineFormat format = SplineFormat::kJson;
  std::uint64_t bytes = 0;
  std::uint64_t entities = 0, patches = 0, edges = 0, vertices = 0, shells = 0;
  std::vector<std::uint64_t> flipped;  ///< entities whose orientation --orient auto reversed
  std::uint64_t boxes_tried = 0;
  std::optional<OpenQuestion> open;  ///< why there is no proof
  std::vector<RefutationFacts> defects;  ///< of an invalid model: what was proved
  // Of a valid model.
  std::uint64_t bodies = 0, genus = 0, boxes = 0;
  std::vector<PatchShellFacts> shell_facts;
  std::optional<Interval> volume;
};

struct FileReport;
/// As report_json and the texts of report_text.h, for reports with `patches`.
std::string patch_report_json(const FileReport& report);
std::string patch_summary(const PatchReport& report);
std::string patch_details(const FileReport& report);

}  // namespace veritope::cli
