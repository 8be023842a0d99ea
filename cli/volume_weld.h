// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/volume_weld.h: convert --weld: the option, and what it does to a file.
#pragma once
#include <optional>
#include <string>

#include "io/splines/read_splines.h"
#include "report/weld_report.h"
#include "robust/base/result.h"
#include "robust/rational.h"

namespace veritope::cli {

/// The text of EPS. Returns nothing, or what is wrong with it.
std::string take_weld_distance(const std::string& text, std::optional<Rational>& eps);

/// Welds the volumes of the file. The outputs of the report are left empty.
/// @error with the file: as volumes_of and weld
Result<report::WeldReport> weld_volumes(SplineFile& file, const std::string& path,
                                        const Rational& eps);

}  // namespace veritope::cli
