// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms eval.
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cli/dms_verbs.h"
#include "cli/point_source.h"
#include "report/dms_report.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/fast/fast_dms.h"

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
    if (const Status status = try_dms_outputs(options_.files, std::nullopt, options_.json); !status)
      return fail(status.error());
    Stopwatch watch;
    const Result<DmsFile> file = read_dms_file(options_.files[0], options_.reading);
    if (!file) return fail(file.error());
    report_.path = options_.files[0];
    report_.sha256 = file->sha256;
    report_.bytes = file->bytes;
    report_.degree = file->model.degree;
    report_.attributes = all_attributes(file->model);
    report_.is_exact = options_.is_exact;
    report_.defects = find_dms_defects(file->model, kMaxListed);
    const bool is_sound = report_.defects.count == 0;
    if (!is_sound) complain(harmless(dms_refusal(options_.files[0], report_.defects)));
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

  Status evaluate(const DmsModel& model) {
    auto source = open_points(options_.files[1], Decimals::kExact, options_.reading.limits);
    if (!source) return source.error();
    // The map, and attributes over a domain of their own.
    std::vector<const DmsModel*> splines{&model};
    for (const DmsModel& own : model.attribute_domain) splines.push_back(&own);
    std::vector<std::unique_ptr<DmsEvaluator>> exact;
    std::vector<std::unique_ptr<FastDms>> fast;
    FastDmsOptions how;
    how.with_gradient = options_.with_gradient;
    for (const DmsModel* const spline : splines)
      options_.is_exact ? exact.push_back(std::make_unique<DmsEvaluator>(*spline))
                        : fast.push_back(std::make_unique<FastDms>(*spline, how));
    for (PointBatch batch;;) {
      if (const Status status = (*source)->next(batch); !status) return status;
      if (batch.size() == 0) return out_.status();
      std::vector<DmsPointReport> points(batch.size());
      for (const auto& evaluator : exact) evaluate_exactly(*evaluator, batch, points);
      for (const auto& evaluator : fast) evaluate_fast(*evaluator, batch, points);
      for (DmsPointReport& point : points) add(std::move(point));
    }
  }

  // The number of the tetrahedron is that of the first spline.
  static void set_tetrahedron(std::uint32_t tetrahedron, DmsPointReport& point) {
    if (!point.tetrahedron) point.tetrahedron = tetrahedron;
  }
  template <typename List>
  static void append(List&& from, List& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  }

  // Adds the values of one spline to those of the points.
  void evaluate_exactly(DmsEvaluator& evaluator, const PointBatch& batch,
                        std::vector<DmsPointReport>& points) const {
    std::size_t exact = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const bool is_exact = exact < batch.exact.size() && batch.exact[exact].first == i;
      const Vec3d& p = batch.points[i];
      const DmsPoint at = is_exact
                              ? batch.exact[exact++].second
                              : DmsPoint{Rational::from_double(p.x), Rational::from_double(p.y),
                                         Rational::from_double(p.z)};
      if (const auto place = evaluator.locate(at)) {
        DmsValue value = evaluator.evaluate(*place);
        set_tetrahedron(place->tetrahedron, points[i]);
        append(std::move(value.value), points[i].value);
        if (options_.with_gradient) append(std::move(value.gradient), points[i].gradient);
      }
    }
  }

  // A FastDms has the greatest number, with an infinite bound, in the place of one beyond binary64.
  void evaluate_fast(FastDms& fast, const PointBatch& batch,
                     std::vector<DmsPointReport>& points) const {
    const std::size_t n = batch.size(), k = fast.num_components();
    std::vector<double> value(n * k), bound(n * k);
    std::vector<double> gradient(options_.with_gradient ? 3 * n * k : 0), slack(gradient.size());
    std::vector<std::uint32_t> tetrahedron(n);
    FastDmsOutput out{value.data(), bound.data(), nullptr, nullptr, tetrahedron.data()};
    if (options_.with_gradient) out.gradient = gradient.data(), out.gradient_bound = slack.data();
    fast.evaluate(batch.points, out, batch.exact);
    for (std::size_t i = 0; i < n; ++i) {
      DmsPointReport& point = points[i];
      if (tetrahedron[i] != FastDms::kNoTetrahedron) {
        set_tetrahedron(tetrahedron[i], point);
        for (std::size_t c = i * k; c < (i + 1) * k; ++c) {
          point.number.push_back(std::isinf(bound[c]) ? std::copysign(bound[c], value[c])
                                                      : value[c]);
          if (options_.json) add_bounds(value[c], bound[c], point.lo, point.hi);
        }
        for (std::size_t c = 3 * i * k; options_.with_gradient && c < 3 * (i + 1) * k; c += 3) {
          std::vector<double> low, high;
          for (std::size_t a = c; a < c + 3; ++a) add_bounds(gradient[a], slack[a], low, high);
          point.gradient_lo.push_back({low[0], low[1], low[2]});
          point.gradient_hi.push_back({high[0], high[1], high[2]});
        }
      }
    }
  }

  static void add_bounds(double value, double bound, std::vector<double>& lo,
                         std::vector<double>& hi) {
    const auto [low, high] = enclosure_of(value, bound);
    lo.push_back(low), hi.push_back(high);
  }

  void add(DmsPointReport point) {
    if (options_.json != "-") out_.write(dms_point_text(point));
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
