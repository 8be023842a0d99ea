// SPDX-License-Identifier: LGPL-3.0-or-later
// report/spline_report.h: what veritope info says about spline files.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "interval/exact_box.h"
#include "io/model_file.h"
#include "report/exit_code.h"
#include "report/text_style.h"
#include "solids/base/finding.h"

namespace veritope::report {

struct SplineReport {
  std::string path;
  ExitCode exit = kExitValid;
  std::optional<SplineFile> file;     ///< nothing: unreadable
  std::vector<std::string> lossless;  ///< formats that hold it without loss
  std::optional<Finding> fault;
};

/// The element of "files" of veritope-info-1; one line.
std::string spline_json(const SplineReport& report);
std::string spline_text(const SplineReport& report, const Style& style);

/// The sides of the least box of the control points, homogeneous ones divided by their weights: it contains the
/// splines. One side a coordinate of the entity; empty without points. For trimmed surfaces and models: the box of
/// their surfaces, not of their loops.
std::vector<ExactInterval> control_box(const SplineEntity& entity);
/// `box` grows to hold `other`; coordinates that only one of them has stay.
void unite(std::vector<ExactInterval>& box, const std::vector<ExactInterval>& other);

}  // namespace veritope::report
