// SPDX-License-Identifier: LGPL-3.0-or-later
// report/report_text.h: reports for people. The first line is the verdict; what programs read is report/report_json.h.
#pragma once
#include <cstddef>
#include <string>

#include "report/file_report.h"
#include "report/text_style.h"

namespace veritope::report {

/// How a report is shown as text.
struct TextOptions {
  /// For standard output: verdict lines are broken only on a terminal, the lines below them at 100 columns at the most.
  static TextOptions of_stdout();

  Style style;
  std::size_t verdict_width = kNoWidth;  ///< of verdict lines
  std::size_t width = 100;               ///< of the lines below them
  std::size_t path_width =
      0;  ///< paths are filled up to it, and verdicts to one width, if it is not 0
  bool shows_seconds = false;  ///< those of runs that took long
  /// List pairs of faces that intersect improperly one by one, not only the places where they do.
  bool lists_pairs = false;
};

/// "VALID  part.stl  1 body, genus 1, volume 123.5 (checked)\n"
std::string verdict_line(const FileReport& report, const TextOptions& options);

/// "1 body, genus 1, volume 123.5", "4 boundary edges", or why there is no verdict.
std::string summary_text(const FileReport& report);

/// What follows the verdict line: what is wrong and what helps, counts and measures, the certificate.
std::string details_text(const FileReport& report, const TextOptions& options);

/// Lines of a report.
std::string collar_text(const CollarFacts& collar);

/// "standard input", or the name without what could drive a terminal.
std::string shown_path(const std::string& path);

}  // namespace veritope::report
