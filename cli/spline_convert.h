// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/spline_convert.h: veritope convert for spline files.
#pragma once
#include <string>

#include "cli/exit_code.h"
#include "cli/options.h"
#include "cli/output.h"

namespace veritope::cli {

/// --format says so, or the extension, or, if the extension says nothing, the first bytes of a regular file.
bool is_spline_input(const std::string& path, const Options& options);

/// REQUIRES is_spline_input(options.files[0], options).
ExitCode convert_splines(const Options& options, StandardOutput& out);

}  // namespace veritope::cli
