// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms refine.
#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/dms_verbs.h"
#include "cli/option_groups.h"
#include "cli/output_plan.h"
#include "cli/progress.h"
#include "io/base/exact_number.h"
#include "io/dms/write_dms.h"
#include "report/dms_refine_report.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/dms/dms_insert.h"

namespace veritope::cli {
namespace {

struct DmsRefineChoice {
  std::string model;
  std::optional<std::string> output;
  std::optional<DmsPoint> at;
  DmsCloud others;  // t_1, t_2, ...
  std::optional<Rational> max_change;
  std::optional<std::string> json;
  ModelReadOptions reading;
};

std::string take_at(const std::string& text, std::optional<DmsPoint>& at) {
  return take_dms_point(text, at.emplace());
}

std::string take_max_change(const std::string& text, std::optional<Rational>& most) {
  Rational number;
  if (read_exact_number(text, {}, number) != DecimalFault::kNone ||
      number.sign() == Sign::kNegative)
    return "must be a number >= 0, not " + text;
  most = std::move(number);
  return "";
}

// "x,y,z;x,y,z;..."
std::string take_cloud(std::string_view text, DmsCloud& cloud) {
  cloud.clear();
  for (bool is_more = true; is_more;) {
    const std::size_t end = std::min(text.find(';'), text.size());
    if (std::string wrong = take_dms_point(text.substr(0, end), cloud.emplace_back());
        !wrong.empty())
      return wrong;
    is_more = end < text.size();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return "";
}

class DmsRefineRun {
 public:
  DmsRefineRun(const DmsRefineChoice& options, StandardOutput& out)
      : options_(options), out_(out) {}

  ExitCode run() {
    if (const Status status = try_dms_outputs({options_.model}, options_.output, options_.json);
        !status)
      return fail(status.error());
    Stopwatch watch;
    const Result<DmsFile> file = read_dms_file(options_.model, options_.reading);
    if (!file) return fail(file.error());
    report_.path = options_.model;
    report_.sha256 = file->sha256;
    report_.bytes = file->bytes;
    report_.output = *options_.output;
    report_.at = *options_.at;
    report_.max_change = options_.max_change;
    const Result<ExitCode> refined = refine(file->model);
    if (!refined) return fail(refined.error());
    report_.seconds = watch.lap();
    if (!options_.json) return *refined;
    const Status written = write_output(*options_.json, dms_refine_json(report_), out_);
    return written ? *refined : first_of(*refined, fail(written.error()));
  }

 private:
  static constexpr std::size_t kMaxListed = 100;

  static ExitCode refuse(const std::string& why, ExitCode exit = kExitInvalid) {
    complain(harmless(why));
    return exit;
  }

  Result<ExitCode> refine(const DmsModel& model) {
    report_.defects = find_dms_defects(model, kMaxListed);
    if (report_.defects.count > 0) return refuse(dms_refusal(options_.model, report_.defects));
    if (model.control.is_separate)
      return refuse(options_.model +
                    ": refine needs shared control points, and these are separate");
    DmsCloud cloud{*options_.at};
    cloud.insert(cloud.end(), options_.others.begin(), options_.others.end());
    Result<DmsInsertion> inserted = with_progress(options_.model, "inserting the vertex",
                                                  [&] { return insert_dms_vertex(model, cloud); });
    if (!inserted) return inserted.error();
    report_.insertion = std::move(*inserted);
    report_.defects = report_.insertion->defects;
    if (report_.defects.count > 0)
      return refuse(dms_refusal("with the new vertex", report_.defects));
    const bool is_small =
        !options_.max_change || is_within(*report_.insertion, *options_.max_change);
    report_.is_written = is_small;
    if (is_small) {
      const Status written =
          write_output(*options_.output, write_dms(report_.insertion->model), out_);
      if (!written) return written.error();
    }
    if (options_.output != "-" && options_.json != "-")
      out_.write(fold(dms_refine_text(report_), verdict_width()));
    if (is_small) return kExitValid;
    return refuse("the map may change by more than --max-change", kExitUndecided);
  }

  const DmsRefineChoice& options_;
  StandardOutput& out_;
  DmsRefineReport report_;
};

}  // namespace

RunCommand declare_dms_refine(OptionSet& set) {
  const auto o = std::make_shared<DmsRefineChoice>();
  declare_plain_file(set, "M", o->model, "a model .vdms with shared control points");
  set.output("-o,--output", o->output, "write the model, .vdms; - is standard output");
  set.option(
      "--at", "X,Y,Z", [o](const std::string& t) { return take_at(t, o->at); },
      "the vertex: inside of a tetrahedron, on a face or an edge");
  set.option(
      "--cloud", "C", [o](const std::string& t) { return take_cloud(t, o->others); },
      "its further knots, x,y,z;x,y,z;...: one less than the\ndegree, or as many; without, it is "
      "collapsed");
  set.option(
      "--max-change", "E", [o](const std::string& t) { return take_max_change(t, o->max_change); },
      "write only if each number is proved to change by at most\nE; status 3 if not");
  declare_json(set, o->json, "write what was cut");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o]() -> std::string {
    if (!o->output) return "-o OUT.vdms is required, the file of the model";
    return o->at ? "" : "--at x,y,z is required, the new vertex";
  });
  return [o](StandardOutput& out) { return DmsRefineRun(*o, out).run(); };
}

}  // namespace veritope::cli
