// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/canonical_convert.h: veritope convert for microstructures and simplex-spline solids: they are written in their
// canonical form, and solids as Bezier cells for viewers.
#pragma once
#include "cli/convert_options.h"
#include "cli/model_input.h"
#include "cli/output.h"
#include "report/exit_code.h"

namespace veritope::cli {

using namespace report;

/// REQUIRES input.kind() == ModelKind::kMicro.
ExitCode convert_micro(ModelInput& input, const ConvertOptions& options, StandardOutput& out);
/// REQUIRES input.kind() == ModelKind::kDms.
ExitCode convert_dms(ModelInput& input, const ConvertOptions& options, StandardOutput& out);

}  // namespace veritope::cli
