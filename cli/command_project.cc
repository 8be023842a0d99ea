// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope project.
#include <memory>

#include "cli/commands.h"
#include "cli/output_plan.h"
#include "cli/projection_report.h"
#include "io/read_model.h"
#include "report/text_style.h"

namespace veritope::cli {

using namespace report;

namespace {

struct Options {
  std::string point;
  InputOptions input;
  std::optional<std::string> json;
  std::uint64_t max_boxes = 100000;  ///< of each curve and surface
};

void declare(OptionSet& set, Options& o) {
  set.operand("POINT", any_text(o.point),
              "x,y,z: decimals, fractions or hexadecimal numbers, exact");
  declare_file(set, "SURFACE", o.input, "a file of splines; - is standard input (with --format)");
  declare_json(set, o.json, "write the report");
  set.number("--max-boxes", o.max_boxes, {1, kMost64},
             "of each curve and surface: parameter boxes to look at\n(100000)");
  declare_format(set, o.input);
}

ExitCode print(const ProjectionReport& report, const Options& options, StandardOutput& out) {
  if (options.json != "-") out.write(projection_text(report));
  if (!options.json) return report.exit;
  const Status status = write_output(*options.json, projection_json(report), out);
  if (status || *options.json == "-") return report.exit;
  return first_of(report.exit, fail(status.error()));
}

ExitCode run(const Options& options, StandardOutput& out) {
  const Result<OutputPlan> plan = plan_outputs(options.input.files, std::nullopt, options.json);
  if (!plan) return fail(plan.error());
  Result<std::vector<Rational>> point = point_from_text(options.point);
  if (!point) {
    complain(harmless(point.error().message));
    return kExitUsage;
  }
  const std::string& path = options.input.files[0];
  const Result<SplineFile> file = read_spline_file(path, options.input.reading);
  if (!file) {
    complain(harmless(to_string(file.error())));
    return kExitUnreadable;
  }
  SolverOptions solver;
  solver.max_boxes = options.max_boxes;
  Result<ProjectionReport> report = project_on(*std::move(point), file->model, solver);
  if (!report) {
    complain(harmless(path + ": " + to_string(report.error())));
    return kExitUnreadable;
  }
  report->path = path;
  report->sha256 = file->sha256;
  return print(*report, options, out);
}

}  // namespace

RunCommand declare_project(OptionSet& set) {
  const auto o = std::make_shared<Options>();
  declare(set, *o);
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
