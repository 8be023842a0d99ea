// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope project.
#include "cli/commands.h"
#include "cli/output_plan.h"
#include "cli/projection_report.h"
#include "report/text_style.h"
#include "io/read_model.h"

namespace veritope::cli {

using namespace report;

ExitCode run_project(const Options& options, StandardOutput& out) {
  const Result<OutputPlan> plan = plan_outputs(options.files, std::nullopt, options.json);
  if (!plan) {
    complain(harmless(to_string(plan.error())));
    return plan.error().code == Code::kBadArgument ? kExitUsage : kExitUnreadable;
  }
  Result<std::vector<Rational>> point = point_from_text(options.point);
  if (!point) {
    complain(harmless(point.error().message));
    return kExitUsage;
  }
  const Result<SplineFile> file = read_spline_file(options.files[0], options.reading);
  if (!file) {
    complain(harmless(to_string(file.error())));
    return kExitUnreadable;
  }
  SolverOptions solver;
  solver.max_boxes = options.max_boxes;
  Result<ProjectionReport> report = project_on(*std::move(point), file->model, solver);
  if (!report) {
    complain(harmless(options.files[0] + ": " + to_string(report.error())));
    return kExitUnreadable;
  }
  report->path = options.files[0];
  report->sha256 = file->sha256;
  if (options.json != "-") out.write(projection_text(*report));
  if (!options.json) return report->exit;
  const Status status = write_output(*options.json, projection_json(*report), out);
  if (status || *options.json == "-") return report->exit;
  complain(harmless(to_string(status.error())));
  return first_of(report->exit, kExitUnreadable);
}

}  // namespace veritope::cli
