// SPDX-License-Identifier: LGPL-3.0-or-later
// report/info_report.h: what veritope info says about a mesh, or about a file of a kind without a report of its own.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/model_file.h"
#include "report/exit_code.h"
#include "report/text_style.h"
#include "solids/base/finding.h"

namespace veritope::report {

struct InfoReport {
  std::string path;
  ExitCode exit = kExitValid;
  bool as_indexed = false;
  std::optional<MeshFile> file;       ///< nothing: unreadable, or of another kind
  std::optional<ModelFile> other;     ///< of another kind
  std::vector<std::string> lossless;  ///< variants that hold it without loss
  bool holds_everywhere = false;      ///< those are all variants
  std::optional<Finding> fault;
};

/// One line: the element of "files" of a veritope-info-1 document.
std::string info_json(const InfoReport& report);
std::string info_text(const InfoReport& report, const Style& style);

}  // namespace veritope::report
