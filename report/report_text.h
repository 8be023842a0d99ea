// SPDX-License-Identifier: LGPL-3.0-or-later
// report/report_text.h: reports for people. The first line is the verdict; what programs read is report/report_json.h.
#pragma once
#include <string>

#include "report/file_report.h"
#include "report/text_style.h"

namespace veritope::report {

/// How much of a report in text is shown.
struct TextOptions {
  Style style;
  /// List pairs of faces that intersect improperly one by one, not only the places where they do.
  bool lists_pairs = false;
};

/// "VALID  part.stl  1 body, genus 1, volume 123.5 (checked)\n"
std::string verdict_line(const FileReport& report, const Style& style);

/// What follows it: counts, each broken rule with its first defects, where to look next.
std::string details_text(const FileReport& report, const TextOptions& options);

/// Lines of a report.
std::string collar_text(const CollarFacts& collar);

/// "standard input", or the name without what could drive a terminal.
std::string shown_path(const std::string& path);

}  // namespace veritope::report
