// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/spline_convert.h: veritope convert for spline files.
#pragma once
#include "cli/exit_code.h"
#include "cli/model_input.h"
#include "cli/options.h"
#include "cli/output.h"

namespace veritope::cli {

/// REQUIRES input.kind() == ModelKind::kSplines.
ExitCode convert_splines(ModelInput& input, const Options& options, StandardOutput& out);

}  // namespace veritope::cli
