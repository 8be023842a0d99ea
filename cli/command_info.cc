// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope info.
#include <new>

#include "cli/commands.h"
#include "cli/output_plan.h"
#include "report/file_report.h"
#include "report/info_report.h"
#include "report/report_json.h"
#include "cli/spline_report.h"
#include "io/mesh/write_mesh.h"

namespace veritope::cli {

using namespace report;
namespace {

// The variants that read back as the same model. Vertex ids are part of it only if they were kept.
std::vector<std::string> lossless_variants(const MeshFile& file, bool as_indexed) {
  std::vector<std::string> names;
  for (const std::string& name : write_variant_names()) {
    const LossReport loss = loss_of(file.mesh, write_options_from_name(name).value());
    if (!loss.coordinates_change && !(as_indexed && loss.indexing_changes)) names.push_back(name);
  }
  return names;
}

InfoReport info_of(const std::string& path, ModelInput& input) {
  InfoReport report;
  report.path = path;
  try {
    Result<ModelFile> model = input.take();
    if (model) {
      MeshFile& file = std::get<MeshFile>(*model);
      report.as_indexed = file.report.as_indexed;
      report.lossless = lossless_variants(file, report.as_indexed);
      report.holds_everywhere = report.lossless.size() == write_variant_names().size();
      report.file = std::move(file);
      return report;
    }
    report.fault = finding_of(model.error());
  } catch (const std::bad_alloc&) {
    report.fault = fault_of("out-of-memory", "not enough memory for this file");
    report.exit = kExitUndecided;
    return report;
  }
  report.exit = kExitUnreadable;
  return report;
}

}  // namespace

ExitCode run_info(const Options& options, StandardOutput& out) {
  const Result<OutputPlan> plan = plan_outputs(options.files, std::nullopt, options.json);
  if (!plan) {
    complain(harmless(to_string(plan.error())));
    return plan.error().code == Code::kBadArgument ? kExitUsage : kExitUnreadable;
  }
  const Style style = style_of_stdout();
  std::vector<std::string> json;
  ExitCode exit = kExitValid;
  for (const std::string& path : options.files) {
    std::string as_json, as_text;
    ModelInput input(path, options.reading);
    if (input.kind() == ModelKind::kSplines) {
      const SplineReport report = spline_report(path, input);
      exit = first_of(exit, report.exit);
      if (options.json) as_json = spline_json(report);
      as_text = spline_text(report, style);
    } else {
      const InfoReport report = info_of(path, input);
      exit = first_of(exit, report.exit);
      if (options.json) as_json = info_json(report);
      as_text = info_text(report, style);
    }
    if (options.json) json.push_back(std::move(as_json));
    if (options.json != "-") out.write(as_text);
  }
  if (!options.json) return exit;
  const Status status = write_output(*options.json, document_json("veritope-info-1", json), out);
  if (status || *options.json == "-") return exit;
  complain(harmless(to_string(status.error())));
  return first_of(exit, kExitUnreadable);
}

}  // namespace veritope::cli
