// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/commands.h: one function a command. Each prints, and returns the exit status.
#pragma once
#include "report/exit_code.h"
#include "cli/options.h"
#include "cli/output.h"

namespace veritope::cli {

using namespace report;

ExitCode run_certify(const Options& options, StandardOutput& out);
ExitCode run_info(const Options& options, StandardOutput& out);
ExitCode run_convert(const Options& options, StandardOutput& out);
ExitCode run_intersect(const Options& options, StandardOutput& out);
ExitCode run_project(const Options& options, StandardOutput& out);
ExitCode run_cover(const Options& options, StandardOutput& out);
ExitCode run_explain(const Options& options, StandardOutput& out);
ExitCode run_explain_certificate(const Options& options, StandardOutput& out);
ExitCode run_predicate(const Options& options, StandardOutput& out);
ExitCode run_selftest(const Options& options, StandardOutput& out);
ExitCode run_corpus(const Options& options, StandardOutput& out);

}  // namespace veritope::cli
