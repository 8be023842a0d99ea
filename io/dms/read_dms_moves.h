// SPDX-License-Identifier: LGPL-3.0-or-later
// io/dms/read_dms_moves.h: a script of moves of a simplex-spline solid. The format: docs/cli/dms-edit.md.
#pragma once
#include <vector>

#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "solids/dms/dms_moves.h"

namespace veritope {

/// The moves of a script for this model: their numbers are in range. REQUIRES a model that validate() accepts.
/// @error kSyntax, kTruncated, kNotFinite, kIndexOutOfRange, kOverLimit, kBadArgument, with the line
Result<std::vector<DmsMove>> read_dms_moves(const Source& source, const ReadLimits& limits,
                                            const DmsModel& model);

}  // namespace veritope
