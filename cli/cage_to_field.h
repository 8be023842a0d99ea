// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/cage_to_field.h: the cage that follows the field of a file, and what is said of it.
#pragma once
#include <string>

#include "cli/cage_options.h"
#include "report/cage_report.h"
#include "robust/base/result.h"
#include "solids/micro/cage/cage_content.h"

namespace veritope::cli {

struct FittedCage {
  CellVolume cell;
  report::CageReport::Fit report;
  std::string sha256;  ///< of the field
};

/// @param content  what has to lie inside, too; null for nothing
/// @error as read_field, with the file; as fit_cage; kBadArgument where all vectors are at one place
Result<FittedCage> fitted_cage(const CageOptions& options, const CageContent* content);

}  // namespace veritope::cli
