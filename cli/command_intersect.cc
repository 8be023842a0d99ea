// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope intersect.
#include "cli/commands.h"
#include "cli/intersection_report.h"
#include "cli/output_plan.h"
#include "cli/progress.h"
#include "report/text_style.h"
#include "io/read_model.h"

namespace veritope::cli {

using namespace report;
namespace {

bool ends_with(const std::string& text, const char* end) { return text.ends_with(end); }

/// Intersects every surface of one model with every one of the other.
Result<IntersectionReport> intersect_models(const std::array<SplineFile, 2>& files,
                                            const Options& options, Progress& progress) {
  IntersectionReport report;
  const auto first = surfaces_of(files[0].model), second = surfaces_of(files[1].model);
  for (std::size_t k = 0; k < 2; ++k) {
    if (!(k == 0 ? first : second).empty()) continue;
    Error error{Code::kBadArgument, {}, "there is no surface in it"};
    error.place.file = options.files[k];
    return error;
  }
  for (const SplineFile& file : files) report.ignored_triangles += count_triangles(file.model);
  IntersectionOptions how;
  how.gap = options.gap;
  how.budget.pairs = options.max_pairs;
  for (const NamedSurface& a : first)
    for (const NamedSurface& b : second) {
      progress.phase(options.files[0], "intersecting " + std::to_string(++report.num_pairs) +
                                           " of " + std::to_string(first.size() * second.size()));
      auto found = intersect(*a.surface, *b.surface, how);
      if (!found) {
        Error error = found.error();
        const bool is_first = error.message.find("the first surface") != std::string::npos;
        error.message =
            "entity " + std::to_string(is_first ? a.entity : b.entity) + ": " + error.message;
        error.place.file = options.files[is_first ? 0 : 1];
        return error;
      }
      report.ignores_trimming = report.ignores_trimming || a.is_trimmed || b.is_trimmed;
      const bool is_empty = found->branches.empty() && found->overlaps.empty() &&
                            found->tangencies.empty() && found->unresolved.empty();
      if (!is_empty) report.pairs.push_back({a, b, std::move(*found)});
    }
  return report;
}

}  // namespace

ExitCode run_intersect(const Options& options, StandardOutput& out) {
  Result<OutputPlan> plan = plan_outputs(options.files, std::nullopt, options.json);
  if (plan && options.curves) {
    const Status apart =
        check_output("--output", *options.curves, options.files, *plan, options.json);
    if (!apart) plan = apart.error();
  }
  if (!plan) {
    complain(harmless(to_string(plan.error())));
    return plan.error().code == Code::kBadArgument ? kExitUsage : kExitUnreadable;
  }
  if (options.curves && !ends_with(*options.curves, ".json") &&
      !ends_with(*options.curves, ".vtu")) {
    complain(harmless(*options.curves + ": the name must end in .json or .vtu"));
    return kExitUsage;
  }
  std::array<SplineFile, 2> files;
  for (std::size_t k = 0; k < 2; ++k) {
    auto file = read_spline_file(options.files[k], options.reading);
    if (!file) {
      complain(harmless(to_string(file.error())));
      return kExitUnreadable;
    }
    files[k] = std::move(*file);
  }
  Progress progress(true);
  auto report = intersect_models(files, options, progress);
  progress.clear();
  if (!report) {
    complain(harmless(to_string(report.error())));
    return kExitUnreadable;
  }
  for (std::size_t k = 0; k < 2; ++k)
    report->paths[k] = options.files[k], report->sha256[k] = files[k].sha256;
  if (options.json != "-") out.write(intersection_text(*report));
  ExitCode exit = report->exit();
  const auto write = [&](const std::string& path, const std::string& text) {
    const Status status = write_output(path, text, out);
    if (status || path == "-") return;
    complain(harmless(to_string(status.error())));
    exit = first_of(exit, kExitUnreadable);
  };
  if (options.curves)
    write(*options.curves,
          ends_with(*options.curves, ".vtu") ? curves_vtu(*report) : curves_json(*report));
  if (options.json) write(*options.json, intersection_json(*report));
  return exit;
}

}  // namespace veritope::cli
