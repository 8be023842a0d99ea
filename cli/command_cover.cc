// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope cover.
#include <cmath>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/cover_picture.h"
#include "cli/did_you_mean.h"
#include "cli/output_plan.h"
#include "cli/progress.h"
#include "io/read_model.h"
#include "report/report_text.h"
#include "report/sweep_report.h"
#include "solids/interval_boxes/condition_sweep.h"
#include "solids/star_box/star_box.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/stand_in.h"

namespace veritope::cli {

using namespace report;
namespace {

struct CoverOptions {
  InputOptions input;
  std::string output;  ///< empty: none
  CoverPart part = CoverPart::kCollar;
  std::optional<int> sweep;
  std::optional<double> eps;  ///< nothing: chosen by the size of the model
  std::optional<std::string> json;
  bool orient_auto = false, quiet = false;
  LimitOptions limits;
};

void declare(OptionSet& set, CoverOptions& o) {
  const auto take_part = [&o](const std::string& name) -> std::string {
    const auto part = cover_part_from_name(name);
    if (!part)
      return "must be boxes, collar, outer or inner, not " + name +
             did_you_mean(name, {"boxes", "collar", "outer", "inner"});
    o.part = *part;
    return "";
  };
  declare_file(set, "MODEL", o.input, "a file of patches (itd, g2, mfem, gismo, vjson)");
  set.option("-o,--output", "F", any_text(o.output),
             "the new file: .vtu, .obj, .ply, .off or .stl");
  set.option("--what", "W", take_part, "boxes; cells: collar (default); solids: outer, inner");
  set.number("--sweep", o.sweep, {0, kMaxSweep},
             "say which of A, B1, B2, C1, C2, C3, C3*, K1-K3 hold\nfor boxes of size EPS, halved N "
             "times; -o: the last");
  set.excludes("--sweep", "--what");
  set.length("--eps", "EPS", o.eps, "the first EPS (a quarter of the model or less)");
  set.needs("--eps", "--sweep");
  declare_json(set, o.json, "the table");
  set.needs("--json", "--sweep");
  declare_orientation(set, o.orient_auto, "patches");
  set.flag("-q,--quiet", o.quiet, "nothing on standard output, no progress");
  declare_format(set, o.input);
  declare_limits(set, o.limits);
}

std::string contradiction(const CoverOptions& o) {
  if (o.output.empty() && !o.sweep) return "-o,--output is required";
  if (o.output == "-") return "--output needs a file name, not -";
  return "";
}

/// The greatest power of two that is at most a quarter of the longest side of the box of the model's control points.
double default_eps(BoundaryModel& model) {
  const Box3d all = hull_of_roots(model.forest());
  // Twice, because the exponent of an unbounded hull is the greatest int.
  return std::ldexp(std::ldexp(1, std::ilogb(extent(all))), -2 - model.forest().scale());
}

/// Budgets, in boxes and cells: a row takes seconds, tens of them at worst. What they do not suffice for is undecided.
SweepOptions sweep_budgets(const LimitOptions& limits) {
  SweepOptions out;
  out.boxes.max_boxes = 4'000;
  out.conditions.trace.max_cells = 500;
  out.conditions.max_cells = 50'000;
  out.conditions.max_intersections = 50'000;
  out.conditions.max_listed = 1;
  out.conditions.stops_at_refutation = true;
  out.max_cells = 6'000;
  if (limits.max_cells) {
    out.max_cells = std::min(out.max_cells, *limits.max_cells);
    out.boxes.max_boxes = std::min<std::size_t>(out.boxes.max_boxes, *limits.max_cells);
  }
  return out;
}

class CoverRun {
 public:
  CoverRun(const CoverOptions& options, StandardOutput& out)
      : options_(options),
        out_(out),
        progress_(!options.quiet),
        budget_(memory_allowed(options.limits.max_memory())) {}

  ExitCode run() {
    const ExitCode exit = look();
    progress_.clear();
    if (!words_.empty()) complain(harmless(words_));
    if (!said_.empty() && !options_.quiet) out_.write(fold(said_, verdict_width()));
    return exit;
  }

 private:
  ExitCode look() {
    phase("reading");
    const Result<SplineFile> file =
        read_spline_file(options_.input.files[0], options_.input.reading);
    if (!file) return fail(kExitUnreadable, file.error());
    const Result<std::optional<StandIn>> stand_in = stand_in_of(*file);
    if (!stand_in) return fail(kExitUnreadable, stand_in.error());
    const bool is_of_volumes = *stand_in && (*stand_in)->is_of_volumes;
    const PatchOrientation orientation =
        options_.orient_auto && !is_of_volumes ? PatchOrientation::kAuto : PatchOrientation::kKeep;
    Result<FilePatches> patches =
        *stand_in ? file_patches((*stand_in)->file.model, orientation, (*stand_in)->faces)
                  : file_patches(file->model, orientation);
    if (!patches) return fail(kExitUnreadable, patches.error());
    if (patches->not_covered) return fail(kExitUndecided, patches->not_covered->message);
    sha256_ = file->sha256;
    if (!options_.sweep) return cover(*patches);
    if (auto open = open_faces_text(*patches)) return fail(kExitUndecided, *open);
    return sweep(*patches->complex);
  }

  ExitCode sweep(PatchComplex complex) {
    Result<BoundaryModel> model = BoundaryModel::make(std::move(complex), &budget_);
    if (!model) return fail(kExitUndecided, model.error());
    phase("asking conditions");
    const SweepOptions budgets = sweep_budgets(options_.limits);
    const auto rows = sweep_conditions(*model, options_.eps.value_or(default_eps(*model)),
                                       *options_.sweep, budgets);
    if (!rows) return fail(kExitUnreadable, rows.error());
    if (options_.json != "-") said_ = sweep_text(*rows);
    phase("writing");
    if (options_.json) {
      const Status status =
          write_output(*options_.json, sweep_json(options_.input.files[0], sha256_, *rows), out_);
      if (!status) return fail(kExitUnreadable, status.error());
    }
    return options_.output.empty() ? kExitValid : write_boxes(*model, finest_row(*rows));
  }

  ExitCode write_boxes(BoundaryModel& model, const SweepRow* row) {
    if (row == nullptr) return fail(kExitUndecided, "no boxes were made, and nothing is written");
    budget_.forgive();
    const auto boxes = make_surface_cover(model, row->eps, sweep_budgets(options_.limits).boxes);
    if (!boxes) return fail(kExitUnreadable, boxes.error());
    return write(surface_boxes_picture(options_.output, *boxes));
  }

  ExitCode cover(FilePatches& patches) {
    phase("looking for star boxes");
    FileDecisionOptions how;
    if (options_.part != CoverPart::kBoxes) how.frame = FrameWanted::kPlain;
    how.may_turn_shells = options_.orient_auto;
    how.search.budget = &budget_;
    how.search.cover.work = &progress_.work();
    if (options_.limits.max_cells) how.search.cover.max_boxes = *options_.limits.max_cells;
    auto [decision, forest] = decide_file_patches(patches, how);
    if (decision.refutation)
      return fail(kExitInvalid, "the model is invalid: veritope certify says where");
    if (!decision.is_valid) return fail(kExitUndecided, decision.open->message);
    said_ = detail_line("star boxes", std::to_string(decision.cover.boxes.size()));
    PatchCollarSearch search;
    if (options_.part != CoverPart::kBoxes) {
      phase("looking for a collar");
      CollarSearchOptions limits;
      if (options_.limits.max_cells) limits.max_cells = *options_.limits.max_cells;
      search = find_patch_collar(*forest, decision.cover, limits);
      said_ += collar_text(collar_facts(search, *forest));
      if (!search.collar)
        return fail(kExitUndecided, "no collar was found, and nothing is written");
    }
    phase("writing");
    return write(cover_picture(options_.part, options_.output, *forest, decision.cover,
                               search.collar ? &*search.collar : nullptr));
  }

  ExitCode write(const Result<std::string>& bytes) {
    if (!bytes) return fail(kExitUnreadable, bytes.error());
    const Status status = write_output(options_.output, *bytes, out_);
    return status ? kExitValid : fail(kExitUnreadable, status.error());
  }

  ExitCode fail(ExitCode exit, const std::string& words) {
    words_ = options_.input.files[0] + ": " + words;
    return exit;
  }
  // The file that the error names, if it names one, is the model or an output.
  ExitCode fail(ExitCode exit, const Error& error) {
    if (error.place.file.empty()) return fail(exit, to_string(error));
    words_ = to_string(error);
    return exit;
  }
  void phase(const char* what) { progress_.phase(harmless(options_.input.files[0]), what); }

  const CoverOptions& options_;
  StandardOutput& out_;
  Progress progress_;
  std::string words_, said_, sha256_;
  MemoryBudget budget_;
};

Status check_outputs(const CoverOptions& options) {
  const std::vector<std::string>& files = options.input.files;
  const Result<OutputPlan> plan = plan_outputs(files, std::nullopt, options.json);
  if (!plan) return plan.error();
  if (options.output.empty()) return try_outputs(*plan, {options.json});
  if (Status status = check_output("--output", options.output, files, *plan, options.json); !status)
    return status;
  return try_outputs(*plan, {options.json, options.output});
}

ExitCode run(const CoverOptions& options, StandardOutput& out) {
  if (const Status status = check_outputs(options); !status) return fail(status.error());
  if (!options.output.empty() && !is_cover_file(options.output)) {
    complain(harmless(options.output + ": the name must end in .vtu, .obj, .ply, .off or .stl"));
    return kExitUsage;
  }
  return CoverRun(options, out).run();
}

}  // namespace

RunCommand declare_cover(OptionSet& set) {
  const auto o = std::make_shared<CoverOptions>();
  declare(set, *o);
  set.rule([o] { return contradiction(*o); });
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
