// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope intersect.
#include <memory>

#include "cli/commands.h"
#include "cli/intersection_picture.h"
#include "cli/output_plan.h"
#include "cli/progress.h"
#include "io/read_model.h"
#include "report/intersection_report.h"
#include "report/text_style.h"

namespace veritope::cli {

using namespace report;
namespace {

struct IntersectOptions {
  InputOptions input;
  std::optional<std::string> curves, json;
  double gap = 0;  ///< 0: chosen by the size of the model
  std::uint64_t max_pairs = 200000000;
};

void declare(OptionSet& set, IntersectOptions& o) {
  set.operands("A B", o.input.files, "two files of splines; - is standard input (with --format)",
               2);
  set.text("-o,--output", o.curves, "write the curves; F ends in .json or .vtu");
  declare_json(set, o.json, "write the report");
  set.length("--gap", "D", o.gap,
             "the gap to aim at between the images of a curve in both\nsurfaces (2^-24 of the "
             "first one's extent)");
  set.number("--max-pairs", o.max_pairs, {1, kMost64}, "rectangles to compare at most (200000000)");
  declare_format(set, o.input);
}

/// Intersects every surface of one model with every surface of the other.
Result<IntersectionReport> intersect_models(const std::array<SplineFile, 2>& files,
                                            const IntersectOptions& options, Progress& progress) {
  IntersectionReport report;
  const auto first = surfaces_of(files[0].model), second = surfaces_of(files[1].model);
  for (std::size_t k = 0; k < 2; ++k) {
    if (!(k == 0 ? first : second).empty()) continue;
    Error error{Code::kBadArgument, {}, "there is no surface in it"};
    error.place.file = options.input.files[k];
    return error;
  }
  for (const SplineFile& file : files) report.ignored_triangles += count_triangles(file.model);
  IntersectionOptions how;
  how.gap = options.gap;
  how.budget.pairs = options.max_pairs;
  for (const NamedSurface& a : first)
    for (const NamedSurface& b : second) {
      progress.phase(options.input.files[0], "intersecting " + std::to_string(++report.num_pairs) +
                                                 " of " +
                                                 std::to_string(first.size() * second.size()));
      auto found = intersect(*a.surface, *b.surface, how);
      if (!found) {
        Error error = found.error();
        const bool is_first = error.message.find("the first surface") != std::string::npos;
        error.message =
            "entity " + std::to_string(is_first ? a.entity : b.entity) + ": " + error.message;
        error.place.file = options.input.files[is_first ? 0 : 1];
        return error;
      }
      report.ignores_trimming = report.ignores_trimming || a.is_trimmed || b.is_trimmed;
      const bool is_empty = found->branches.empty() && found->overlaps.empty() &&
                            found->tangencies.empty() && found->unresolved.empty();
      if (!is_empty) report.pairs.push_back({a, b, std::move(*found)});
    }
  return report;
}

Status check_outputs(const IntersectOptions& options) {
  const std::vector<std::string>& files = options.input.files;
  const Result<OutputPlan> plan = plan_outputs(files, std::nullopt, options.json);
  if (!plan) return plan.error();
  if (options.curves)
    if (Status status = check_output("--output", *options.curves, files, *plan, options.json);
        !status)
      return status;
  return try_outputs(*plan, {options.json, options.curves});
}

ExitCode print(const IntersectionReport& report, const IntersectOptions& options,
               StandardOutput& out) {
  ExitCode exit = report.exit();
  const auto write = [&](const std::string& path, const std::string& text) {
    const Status status = write_output(path, text, out);
    if (!status && path != "-") exit = first_of(exit, fail(status.error()));
  };
  if (options.json != "-") out.write(fold(intersection_text(report), verdict_width()));
  if (options.curves)
    write(*options.curves,
          options.curves->ends_with(".vtu") ? curves_vtu(report) : curves_json(report));
  if (options.json) write(*options.json, intersection_json(report));
  return exit;
}

ExitCode run(const IntersectOptions& options, StandardOutput& out) {
  if (const Status status = check_outputs(options); !status) return fail(status.error());
  if (options.curves && !options.curves->ends_with(".json") && !options.curves->ends_with(".vtu")) {
    complain(harmless(*options.curves + ": the name must end in .json or .vtu"));
    return kExitUsage;
  }
  std::array<SplineFile, 2> files;
  for (std::size_t k = 0; k < 2; ++k) {
    auto file = read_spline_file(options.input.files[k], options.input.reading);
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
    report->paths[k] = options.input.files[k], report->sha256[k] = files[k].sha256;
  return print(*report, options, out);
}

}  // namespace

RunCommand declare_intersect(OptionSet& set) {
  const auto o = std::make_shared<IntersectOptions>();
  declare(set, *o);
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
