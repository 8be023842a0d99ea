// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms eval.
#include <memory>
#include <utility>
#include <variant>

#include "cli/dms_verbs.h"
#include "cli/output_plan.h"
#include "cli/point_source.h"
#include "report/dms_report.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/dms/dms_evaluator.h"

namespace veritope::cli {
namespace {

struct DmsEvalOptions {
  std::vector<std::string> files;  // M, POINTS
  bool is_exact = false, with_gradient = false;
  std::optional<std::string> json;
  ModelReadOptions reading;
};

class DmsEvalRun {
 public:
  DmsEvalRun(const DmsEvalOptions& options, StandardOutput& out) : options_(options), out_(out) {}

  ExitCode run() {
    if (const Status status = check_outputs(); !status) return fail(status.error());
    Stopwatch watch;
    const Result<DmsFile> file = read_dms_file(options_.files[0], options_.reading);
    if (!file) return fail(file.error());
    report_.path = options_.files[0];
    report_.sha256 = file->sha256;
    report_.bytes = file->bytes;
    report_.degree = file->model.degree;
    report_.attributes = file->model.attributes;
    report_.is_exact = options_.is_exact;
    report_.defects = find_dms_defects(file->model, kMaxListed);
    const bool is_sound = report_.defects.count == 0;
    if (!is_sound) complain(harmless(refusal()));
    if (is_sound)
      if (const Status status = evaluate(file->model); !status) return fail(status.error());
    report_.seconds = watch.lap();
    const ExitCode exit = is_sound ? kExitValid : kExitInvalid;
    if (!options_.json) return exit;
    const Status written = write_output(*options_.json, dms_eval_json(report_), out_);
    return written ? exit : first_of(exit, fail(written.error()));
  }

 private:
  static constexpr std::size_t kMaxListed = 100;

  Status check_outputs() const {
    std::vector<std::string> inputs;
    for (const std::string& file : options_.files)
      if (file != "-") inputs.push_back(file);
    const Result<OutputPlan> plan = plan_outputs(inputs, std::nullopt, options_.json);
    if (!plan) return plan.error();
    return try_outputs(*plan, {options_.json});
  }

  std::string refusal() const {
    const DmsDefect& first = report_.defects.first[0];
    return options_.files[0] + ": " + fault_name(first.fault) + ": " + to_string(first) +
           (report_.defects.count > 1
                ? "; " + counted(report_.defects.count - 1, "more defect", "more defects")
                : "");
  }

  Status evaluate(const DmsModel& model) {
    DmsEvaluator evaluator(model);
    auto source = open_points(options_.files[1], Decimals::kExact, options_.reading.limits);
    if (!source) return source.error();
    for (PointBatch batch;;) {
      if (const Status status = (*source)->next(batch); !status) return status;
      if (batch.size() == 0) return out_.status();
      std::size_t exact = 0;
      for (std::size_t i = 0; i < batch.size(); ++i) {
        const bool is_exact = exact < batch.exact.size() && batch.exact[exact].first == i;
        const Vec3d& p = batch.points[i];
        const DmsPoint point =
            is_exact ? batch.exact[exact++].second
                     : DmsPoint{Rational::from_double(p.x), Rational::from_double(p.y),
                                Rational::from_double(p.z)};
        add(evaluator, point);
      }
    }
  }

  void add(DmsEvaluator& evaluator, const DmsPoint& at) {
    DmsPointReport point;
    if (const auto place = evaluator.locate(at)) {
      DmsValue value = evaluator.evaluate(*place);
      point.tetrahedron = place->tetrahedron;
      point.value = std::move(value.value);
      if (options_.with_gradient) point.gradient = std::move(value.gradient);
    }
    if (options_.json != "-") out_.write(dms_point_text(point, options_.is_exact));
    if (options_.json) report_.points.push_back(std::move(point));
  }

  const DmsEvalOptions& options_;
  StandardOutput& out_;
  DmsEvalReport report_;
};

std::string eval_contradiction(const DmsEvalOptions& o) {
  if (o.files.size() == 2 && o.files[0] == "-")
    return "M is a file, not standard input: points may come from there";
  if (o.with_gradient && !o.json) return "--gradient requires --json";
  return "";
}

}  // namespace

RunCommand declare_dms_eval(OptionSet& set) {
  const auto o = std::make_shared<DmsEvalOptions>();
  set.operands("M POINTS", o->files,
               "a model .vdms, and points: three numbers a line; - is\nstandard input", 2);
  set.flag("--exact", o->is_exact, "write fractions p/q, not enclosures");
  set.flag("--gradient", o->with_gradient, "write derivatives, too; needs --json");
  declare_json(set, o->json, "write values");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o] { return eval_contradiction(*o); });
  return [o](StandardOutput& out) { return DmsEvalRun(*o, out).run(); };
}

}  // namespace veritope::cli
