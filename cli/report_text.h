// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/report_text.h: reports for people. The first line is the verdict; what programs read is cli/report_json.h.
#pragma once
#include <string>

#include "cli/file_report.h"
#include "cli/report_json.h"
#include "cli/text_style.h"

namespace veritope::cli {

/// "VALID  part.stl  1 body, genus 1, volume 123.5 (checked)\n"
std::string verdict_line(const FileReport& report, const Style& style);

/// What follows it: counts, each broken rule with its first defects, where to look next.
std::string details_text(const FileReport& report, const Style& style);

/// veritope info.
std::string info_text(const InfoReport& report, const Style& style);

}  // namespace veritope::cli
