// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms xray.
#include <memory>
#include <utility>

#include "cli/dms_verbs.h"
#include "cli/line_reader.h"
#include "io/points/read_point.h"
#include "report/dms_xray_report.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/dms/dms_line.h"

namespace veritope::cli {
namespace {

struct DmsXrayOptions {
  std::vector<std::string> files;  // M, SEGMENTS
  std::optional<std::string> attribute, json;
  ModelReadOptions reading;
};

class DmsXrayRun {
 public:
  DmsXrayRun(const DmsXrayOptions& options, StandardOutput& out) : options_(options), out_(out) {}

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
    report_.attribute = *options_.attribute;
    const Result<DmsComponent> component = dms_component(file->model, *options_.attribute);
    if (!component) return fail(component.error());
    report_.defects = find_dms_defects(file->model, kMaxListed);
    const bool is_sound = report_.defects.count == 0;
    if (!is_sound) complain(harmless(dms_refusal(options_.files[0], report_.defects)));
    if (is_sound)
      if (const Status status = integrate(*component->spline, component->component); !status)
        return fail(status.error());
    report_.seconds = watch.lap();
    const ExitCode exit = is_sound ? kExitValid : kExitInvalid;
    if (!options_.json) return exit;
    const Status written = write_output(*options_.json, dms_xray_json(report_), out_);
    return written ? exit : first_of(exit, fail(written.error()));
  }

 private:
  static constexpr std::size_t kMaxListed = 100;

  Status integrate(const DmsModel& model, std::size_t component) {
    DmsEvaluator evaluator(model);
    DmsLineIntegrator integrator(evaluator);
    Result<LineReader> lines = LineReader::open(options_.files[1]);
    if (!lines) return lines.error();
    PointLines reader(Decimals::kExact, options_.reading.limits, 6);
    for (;;) {
      const Result<std::optional<std::string_view>> text = lines->next();
      if (!text) return text.error();
      if (!*text) return out_.status();
      std::optional<PointFault> fault;
      auto ends = reader.read_segment(**text, fault);
      if (fault) return error(lines->line(), *fault);
      if (ends) add(integrator, {std::move((*ends)[0]), std::move((*ends)[1])}, component);
    }
  }

  void add(DmsLineIntegrator& integrator, const DmsLine& line, std::size_t component) {
    DmsSegmentReport segment;
    segment.mean = integrator.mean(line, component);
    const DmsAbsorption passed = absorption(line, segment.mean);
    segment.integral = passed.integral;
    segment.intensity = passed.intensity;
    if (options_.json != "-") out_.write(dms_segment_text(segment));
    if (options_.json) report_.segments.push_back(std::move(segment));
  }

  Error error(std::uint64_t line, const PointFault& fault) const {
    Error out{Code::kSyntax, {}, "column " + std::to_string(fault.column) + ": " + fault.message};
    out.place.file = (options_.files[1] == "-" ? "standard input" : options_.files[1]) + ":" +
                     std::to_string(line);
    return out;
  }

  const DmsXrayOptions& options_;
  StandardOutput& out_;
  DmsXrayReport report_;
};

std::string xray_contradiction(const DmsXrayOptions& o) {
  if (o.files.size() == 2 && o.files[0] == "-")
    return "M is a file, not standard input: segments may come from there";
  if (!o.attribute) return "--attribute A is required, the name of what is integrated";
  return "";
}

}  // namespace

RunCommand declare_dms_xray(OptionSet& set) {
  const auto o = std::make_shared<DmsXrayOptions>();
  set.operands(
      "M SEGMENTS", o->files,
      "a model .vdms, and segments: six numbers a line, the\ntwo ends; - is standard input", 2);
  set.text("--attribute", o->attribute, "what is integrated, an attribute's name", "A");
  declare_json(set, o->json, "write the integrals");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o] { return xray_contradiction(*o); });
  return [o](StandardOutput& out) { return DmsXrayRun(*o, out).run(); };
}

}  // namespace veritope::cli
