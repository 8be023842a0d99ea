// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope info.
#include <memory>
#include <new>

#include "cli/commands.h"
#include "cli/model_files.h"
#include "cli/model_input.h"
#include "cli/output_plan.h"
#include "io/formats.h"
#include "io/mesh/write_mesh.h"
#include "io/splines/write_splines.h"
#include "report/file_report.h"
#include "report/info_report.h"
#include "report/report_json.h"
#include "report/spline_report.h"
#include "report/text_style.h"

namespace veritope::cli {

using namespace report;
namespace {

struct InfoOptions {
  InputOptions input;
  std::optional<std::string> json;
};

// The variants that read back as the same model. Vertex ids are part of it only if they were kept
// when the file was read.
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
    if (model && !std::holds_alternative<MeshFile>(*model)) {
      report.other = std::move(*model);
      return report;
    }
    if (model) {
      MeshFile& file = std::get<MeshFile>(*model);
      report.as_indexed = file.report.as_indexed;
      report.lossless = lossless_variants(file, report.as_indexed);
      report.holds_everywhere = report.lossless.size() == write_variant_names().size();
      report.file = std::move(file);
      return report;
    }
    report.fault = finding_of(model.error());
    if (is_folder_of_models(path)) report.fault->message += "; certify takes folders, info files";
  } catch (const std::bad_alloc&) {
    report.fault = fault_of("out-of-memory", "not enough memory for this file");
    report.exit = kExitUndecided;
    return report;
  }
  report.exit = kExitUnreadable;
  return report;
}

std::vector<std::string> lossless_formats(const SplineFile& file) {
  std::vector<std::string> names;
  for (const ModelFormat& row : model_formats()) {
    if (row.kind() != ModelKind::kSplines || row.write == nullptr) continue;
    const SplineFormat format = std::get<SplineFormat>(row.id);
    const SplineLoss loss = spline_loss(file.model, format, spline_bytes(file.model, format));
    if (loss.shapes.empty() && loss.dropped.empty() && !loss.unreadable)
      names.emplace_back(row.name);
  }
  return names;
}

SplineReport spline_report(const std::string& path, ModelInput& input) {
  SplineReport report;
  report.path = path;
  try {
    Result<ModelFile> file = input.take();
    if (file) {
      report.file = std::get<SplineFile>(std::move(*file));
      report.lossless = lossless_formats(*report.file);
      return report;
    }
    report.fault = finding_of(file.error());
    report.exit = kExitUnreadable;
  } catch (const std::bad_alloc&) {
    report.file.reset();
    report.fault = fault_of("out-of-memory", "not enough memory for this file");
    report.exit = kExitUndecided;
  }
  return report;
}

struct FileText {
  ExitCode exit = kExitValid;
  std::string json, text;
};

FileText describe(const std::string& path, const InfoOptions& options, const Style& style) {
  ModelInput input(path, options.input.reading);
  if (input.kind() == ModelKind::kSplines) {
    const SplineReport report = spline_report(path, input);
    return {report.exit, options.json ? spline_json(report) : "", spline_text(report, style)};
  }
  const InfoReport report = info_of(path, input);
  return {report.exit, options.json ? info_json(report) : "", info_text(report, style)};
}

ExitCode run(const InfoOptions& options, StandardOutput& out) {
  const Result<OutputPlan> plan = plan_outputs(options.input.files, std::nullopt, options.json);
  if (!plan) return fail(plan.error());
  if (const Status status = try_outputs(*plan, {options.json}); !status)
    return fail(status.error());
  const Style style = style_of_stdout();
  std::vector<std::string> json;
  ExitCode exit = kExitValid;
  for (const std::string& path : options.input.files) {
    FileText file = describe(path, options, style);
    exit = first_of(exit, file.exit);
    if (options.json) json.push_back(std::move(file.json));
    if (options.json != "-") out.write(fold(file.text, verdict_width()));
  }
  if (!options.json) return exit;
  const Status status = write_output(*options.json, document_json("veritope-info-1", json), out);
  if (status || *options.json == "-") return exit;
  return first_of(exit, fail(status.error()));
}

}  // namespace

RunCommand declare_info(OptionSet& set) {
  const auto o = std::make_shared<InfoOptions>();
  declare_files(set, o->input,
                "STL, OBJ, PLY, OFF, ITD, G2, MFEM's MESH, G+Smo's XML,\nVJSON, VMICRO, VDMS; - is "
                "standard input\n(with --format)");
  declare_json(set, o->json, "write it");
  declare_jobs(set, o->input.reading.jobs);
  declare_format(set, o->input);
  declare_reading(set, o->input.reading);
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
