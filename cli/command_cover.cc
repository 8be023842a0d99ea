// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope cover.
#include <optional>

#include "cli/commands.h"
#include "cli/condition_report.h"
#include "cli/cover_picture.h"
#include "cli/output_plan.h"
#include "cli/progress.h"
#include "io/read_model.h"
#include "report/report_text.h"
#include "verify/certify/file_patches.h"

namespace veritope::cli {

using namespace report;
namespace {

class CoverRun {
 public:
  CoverRun(const Options& options, StandardOutput& out)
      : options_(options), out_(out), progress_(!options.quiet) {}

  ExitCode run() {
    const ExitCode exit = look();
    progress_.clear();
    if (!words_.empty()) complain(harmless(options_.files[0] + ": " + words_));
    if (!said_.empty() && !options_.quiet) out_.write(said_);
    return exit;
  }

 private:
  ExitCode look() {
    phase("reading");
    const Result<SplineFile> file = read_spline_file(options_.files[0], options_.reading);
    if (!file) return fail(kExitUnreadable, to_string(file.error()));
    Result<FilePatches> patches = file_patches(
        file->model, options_.orient_auto ? PatchOrientation::kAuto : PatchOrientation::kKeep);
    if (!patches) return fail(kExitUnreadable, to_string(patches.error()));
    if (patches->not_covered) return fail(kExitUndecided, patches->not_covered->message);
    sha256_ = file->sha256;
    return options_.sweep ? sweep(*patches->complex) : cover(*patches);
  }

  ExitCode sweep(PatchComplex complex) {
    Result<BoundaryModel> model = BoundaryModel::make(std::move(complex));
    if (!model) return fail(kExitUndecided, to_string(model.error()));
    phase("asking conditions");
    const SweepOptions budgets = sweep_budgets();
    const auto rows = sweep_conditions(*model, options_.eps.value_or(default_eps(*model)),
                                       *options_.sweep, budgets);
    if (!rows) return fail(kExitUnreadable, to_string(rows.error()));
    if (options_.json != "-") said_ = sweep_text(*rows);
    phase("writing");
    if (options_.json) {
      const Status status =
          write_output(*options_.json, sweep_json(options_.files[0], sha256_, *rows), out_);
      if (!status) return fail(kExitUnreadable, to_string(status.error()));
    }
    return options_.output.empty() ? kExitValid : write_boxes(*model, finest_row(*rows));
  }

  ExitCode write_boxes(BoundaryModel& model, const SweepRow* row) {
    if (row == nullptr) return fail(kExitUndecided, "no boxes were made, and nothing is written");
    const auto boxes = make_surface_cover(model, row->eps, sweep_budgets().boxes);
    if (!boxes) return fail(kExitUnreadable, to_string(boxes.error()));
    return write(surface_boxes_picture(options_.output, *boxes));
  }

  ExitCode cover(FilePatches& patches) {
    phase("looking for star boxes");
    FileDecisionOptions how;
    if (options_.cover_part != CoverPart::kBoxes) how.frame = FrameWanted::kPlain;
    how.may_turn_shells = options_.orient_auto;
    auto [decision, forest] = decide_file_patches(patches, how);
    if (decision.refutation)
      return fail(kExitInvalid, "the model is invalid: veritope certify says where");
    if (!decision.is_valid) return fail(kExitUndecided, decision.open->message);
    said_ = detail_line("star boxes", std::to_string(decision.cover.boxes.size()));
    PatchCollarSearch search;
    if (options_.cover_part != CoverPart::kBoxes) {
      phase("looking for a collar");
      search = find_patch_collar(*forest, decision.cover);
      said_ += collar_text(collar_facts(search, *forest));
      if (!search.collar)
        return fail(kExitUndecided, "no collar was found, and nothing is written");
    }
    phase("writing");
    return write(cover_picture(options_.cover_part, options_.output, *forest, decision.cover,
                               search.collar ? &*search.collar : nullptr));
  }

  ExitCode write(const Result<std::string>& bytes) {
    if (!bytes) return fail(kExitUnreadable, to_string(bytes.error()));
    const Status status = write_output(options_.output, *bytes, out_);
    return status ? kExitValid : fail(kExitUnreadable, to_string(status.error()));
  }

  ExitCode fail(ExitCode exit, std::string words) {
    words_ = std::move(words);
    return exit;
  }
  void phase(const char* what) { progress_.phase(harmless(options_.files[0]), what); }

  const Options& options_;
  StandardOutput& out_;
  Progress progress_;
  std::string words_, said_, sha256_;
};

}  // namespace

ExitCode run_cover(const Options& options, StandardOutput& out) {
  Result<OutputPlan> plan = plan_outputs(options.files, std::nullopt, options.json);
  if (plan && !options.output.empty())
    if (const Status apart =
            check_output("--output", options.output, options.files, *plan, options.json);
        !apart)
      plan = apart.error();
  if (!plan) {
    complain(harmless(to_string(plan.error())));
    return plan.error().code == Code::kBadArgument ? kExitUsage : kExitUnreadable;
  }
  if (!options.output.empty() && !is_cover_file(options.output)) {
    complain(harmless(options.output + ": the name must end in .vtu, .obj, .ply, .off or .stl"));
    return kExitUsage;
  }
  return CoverRun(options, out).run();
}

}  // namespace veritope::cli
