// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/patch_report.h: what veritope certify says about the patches of a spline file, beside the verdict.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/splines/spline_format.h"
#include "verify/certify/patch_collar.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/refutation_facts.h"

namespace veritope::cli {

/// The coarsest collar that was found around the surface, or why none was.
struct CollarReport {
  bool is_found = false;
  std::string message;         ///< if not
  std::optional<Box3d> place;  ///< if known; in the model's units, rounded outward
  std::uint64_t cells = 0;
  /// Of the cells: 2^-level of the root's edge; lengths in the model's units.
  unsigned coarsest_level = 0, finest_level = 0;
  double longest_edge = 0, shortest_edge = 0;
};
/// Lines of a report in text.
std::string collar_text(const CollarReport& collar);
/// `forest` is the one that was searched.
CollarReport collar_report(const PatchCollarSearch& search, const PieceForest& forest);

struct PatchReport {
  SplineFormat format = SplineFormat::kJson;
  std::uint64_t bytes = 0;
  std::uint64_t entities = 0, patches = 0, edges = 0, vertices = 0, shells = 0;
  std::vector<std::uint64_t> flipped;  ///< entities whose orientation --orient auto reversed
  std::uint64_t boxes_tried = 0;
  std::optional<OpenQuestion> open;      ///< why there is no proof
  std::vector<RefutationFacts> defects;  ///< of an invalid model: what was proved
  // Of a valid model.
  std::uint64_t bodies = 0, genus = 0, boxes = 0;
  std::vector<PatchShellFacts> shell_facts;
  std::optional<Interval> volume;
  std::optional<CollarReport> collar;  ///< if it was asked for
};

struct FileReport;
/// As report_json and the texts of report_text.h, for reports with `patches`.
std::string patch_report_json(const FileReport& report);
std::string patch_summary(const PatchReport& report);
std::string patch_details(const FileReport& report);

}  // namespace veritope::cli
