// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope inspect.
#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include "cli/commands.h"
#include "cli/output_plan.h"
#include "io/read_model.h"
#include "io/splines/volumes.h"
#include "report/inspect_report.h"
#include "report/report_text.h"
#include "report/text_style.h"

namespace veritope::cli {
namespace {

using CellPair = std::array<std::uint32_t, 2>;

struct InspectOptions {
  InputOptions input;
  std::optional<CellPair> pair;
  std::optional<std::string> json;
};

std::string take_pair(const std::string& text, std::optional<CellPair>& pair) {
  CellPair out{};
  const char *at = text.data(), *const end = text.data() + text.size();
  const auto first = std::from_chars(at, end, out[0]);
  const bool has_comma = first.ec == std::errc() && first.ptr != end && *first.ptr == ',';
  if (has_comma) {
    const auto second = std::from_chars(first.ptr + 1, end, out[1]);
    if (second.ec == std::errc() && second.ptr == end) {
      pair = out;
      return "";
    }
  }
  return "needs the numbers of two cells A,B, not " + text;
}

ExitCode not_covered(const std::string& path, const std::string& why) {
  complain(harmless(shown_path(path) + ": not covered: " + why));
  return kExitUndecided;
}

// Complains and returns the exit status where there are no elements to report.
Result<InspectReport> elements_of(const std::string& path, const SplineFile& file) {
  Result<std::vector<ExactVolume>> volumes = volumes_of(file);
  if (!volumes) return volumes.error();
  Result<VModel> model = make_v_model(std::move(*volumes), VOrientation::kAuto);
  if (!model) return model.error();
  return inspect_v_model(path, std::move(*model));
}

ExitCode refuse_volumes(const std::string& path, const Error& error) {
  // A message about a cell names it, as "cell 3: ".
  const bool names_place = error.message.starts_with("cell ");
  if (error.code != Code::kOverLimit)
    return not_covered(path, names_place ? error.message : text_of(finding_of(error)));
  complain(harmless(shown_path(path) + ": " + to_string(error)));
  return kExitUnreadable;
}

ExitCode write_report(const InspectReport& report, const InspectOptions& options,
                      StandardOutput& out) {
  const Style style = style_of_stdout();
  if (options.json != "-")
    out.write(
        fold(options.pair ? pair_text(report, *options.pair, style) : inspect_text(report, style),
             verdict_width()));
  if (!options.json) return kExitValid;
  const std::string bytes = options.pair ? pair_json(report, *options.pair) : inspect_json(report);
  const Status status = write_output(*options.json, bytes, out);
  return status || *options.json == "-" ? kExitValid : fail(status.error());
}

ExitCode run(const InspectOptions& options, StandardOutput& out) {
  const std::string& path = options.input.files[0];
  const Result<OutputPlan> plan = plan_outputs(options.input.files, std::nullopt, options.json);
  if (!plan) return fail(plan.error());
  if (const Status status = try_outputs(*plan, {options.json}); !status)
    return fail(status.error());
  const Result<ModelFile> model = read_model_file(path, options.input.reading);
  if (!model) {
    complain(harmless(to_string(model.error())));
    return kExitUnreadable;
  }
  const auto* const file = std::get_if<SplineFile>(&*model);
  if (file == nullptr)
    return not_covered(path, std::string("it is ") + title_of(kind_of(*model)) +
                                 ", and V-models are files of volumes");
  const Result<InspectReport> report = elements_of(path, *file);
  if (!report) return refuse_volumes(path, report.error());
  const std::size_t cells = report->model.num_cells();
  if (options.pair && std::max((*options.pair)[0], (*options.pair)[1]) >= cells) {
    complain("--pair: there are " + std::to_string(cells) + " cells, numbered from 0");
    return kExitUsage;
  }
  return write_report(*report, options, out);
}

}  // namespace

RunCommand declare_inspect(OptionSet& set) {
  const auto o = std::make_shared<InspectOptions>();
  declare_file(set, "MODEL", o->input, "a file of volumes; - is standard input (with --format)");
  set.option(
      "--pair", "A,B", [o = o.get()](const std::string& text) { return take_pair(text, o->pair); },
      "list what these two cells have in common");
  declare_json(set, o->json, "write all elements");
  declare_jobs(set, o->input.reading.jobs);
  declare_format(set, o->input);
  declare_reading(set, o->input.reading);
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
