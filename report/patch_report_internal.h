// SPDX-License-Identifier: LGPL-3.0-or-later
// report/patch_report_internal.h: the parts of reports about patches.
#pragma once
#include <string>

#include "report/report_kinds_internal.h"

namespace veritope::report::internal {

/// Those of a model of which nothing is known are all zero.
const PatchFacts& facts_of(const FileReport& report);

void put_patch_source(const FileReport& report, Json& out);
void put_patch_facts(const FileReport& report, Json& out);
/// Null without one.
Json bounds_json(const std::optional<Interval>& v);

std::string patch_summary(const FileReport& report);
std::string patch_details(const FileReport& report, const TextOptions& options);
std::string patch_findings(const FileReport& report, const TextOptions& options);

}  // namespace veritope::report::internal
