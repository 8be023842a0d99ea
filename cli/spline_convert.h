// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/spline_convert.h: veritope convert for spline files.
#pragma once
#include "cli/convert_options.h"
#include "cli/model_input.h"
#include "cli/output.h"
#include "report/exit_code.h"

namespace veritope::cli {

using namespace report;

/// REQUIRES input.kind() == ModelKind::kSplines.
ExitCode convert_splines(ModelInput& input, const ConvertOptions& options, StandardOutput& out);

/// A mesh as PN-triangles. REQUIRES input.kind() == ModelKind::kMesh, read with normals.
ExitCode convert_to_pn(ModelInput& input, const ConvertOptions& options, StandardOutput& out);

}  // namespace veritope::cli
