// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms make.
#include <algorithm>
#include <charconv>
#include <memory>
#include <span>
#include <utility>

#include "cli/dms_verbs.h"
#include "cli/output_plan.h"
#include "io/base/exact_number.h"
#include "io/dms/write_dms.h"
#include "report/decimal_text.h"
#include "report/text_style.h"
#include "solids/dms/dms_make.h"

namespace veritope::cli {
namespace {

struct DmsMakeChoice {
  std::string domain;
  std::optional<std::string> output;
  std::optional<int> degree;
  DmsMakeOptions make;
  ModelReadOptions reading;
};

// "collapsed", "R" or "R:SEED".
std::string take_clouds(const std::string& text, std::optional<DmsCloudDraw>& clouds) {
  clouds.reset();
  if (text == "collapsed") return "";
  DmsCloudDraw draw;
  const std::size_t colon = text.find(':');
  const std::string radius = text.substr(0, colon);
  if (read_exact_number(radius, {}, draw.radius) != DecimalFault::kNone ||
      draw.radius.sign() == Sign::kNegative)
    return "must be collapsed, or a number R >= 0, or R:SEED, not " + text;
  if (colon != text.npos) {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, draw.seed);
    if (error != std::errc() || stop != end)
      return "needs digits after the colon, the seed, not " + text.substr(colon + 1);
  }
  clouds = std::move(draw);
  return "";
}

std::string take_control(const std::string& text, DmsControlRule& rule) {
  if (text != "greville" && text != "edges") return "must be greville or edges, not " + text;
  rule = text == "greville" ? DmsControlRule::kGreville : DmsControlRule::kEdges;
  return "";
}

// The greatest distance along an axis between a control point and that of the identity.
Rational deviation_of(const DmsModel& model) {
  const auto n = static_cast<std::size_t>(model.degree);
  Rational most;
  for (std::size_t c = 0; c < model.num_control(); ++c) {
    const DmsPoint at = control_place(model, std::span(model.control.at).subspan(c * n, n),
                                      DmsControlRule::kGreville);
    for (std::size_t a = 0; a < 3; ++a) most = std::max(most, abs(model.value(c)[a] - at[a]));
  }
  return most;
}

std::string made_text(const DmsMakeChoice& o, const DmsModel& model) {
  std::size_t knots = 0;
  for (const DmsCloud& cloud : model.clouds) knots += cloud.size();
  std::string text = "wrote  " + unbroken(harmless(*o.output)) + "  degree " +
                     std::to_string(model.degree) + ", " +
                     counted(model.tetrahedra.size(), "tetrahedron", "tetrahedra") + ", " +
                     counted(knots, "knot", "knots") + ", " +
                     counted(model.num_control(), "control point", "control points") + "\n";
  if (o.make.control == DmsControlRule::kEdges)
    text += "  deviation: control points lie up to " + short_decimal(deviation_of(model)) +
            " along an axis from those of the identity\n";
  return text;
}

ExitCode run_make(const DmsMakeChoice& o, StandardOutput& out) {
  if (o.domain != "-")
    if (const Status status = refuse_same({o.domain}, *o.output); !status)
      return fail(status.error());
  if (const Status status = try_output(*o.output); !status) return fail(status.error());
  const Result<DmsFile> domain = read_dms_file(o.domain, o.reading);
  if (!domain) return fail(domain.error());
  DmsMakeOptions options = o.make;
  options.degree = *o.degree;
  const Result<DmsModel> model = make_dms(domain->model, options);
  if (!model) {
    complain(harmless(o.domain + ": " + model.error().message));
    return model.error().code == Code::kBadArgument ? kExitInvalid : kExitUnreadable;
  }
  const Status written = write_output(*o.output, write_dms(*model), out);
  if (!written) return fail(written.error());
  if (*o.output != "-") out.write(fold(made_text(o, *model), verdict_width()));
  return kExitValid;
}

}  // namespace

RunCommand declare_dms_make(OptionSet& set) {
  const auto o = std::make_shared<DmsMakeChoice>();
  declare_plain_file(set, "DOMAIN", o->domain,
                     "a model .vdms of degree 1: the identity on its domain");
  set.output("-o,--output", o->output, "write the model, .vdms; - is standard output");
  set.number("--degree", o->degree, {1, kMaxDmsDegree}, "the degree, 1 to 9");
  set.option(
      "--clouds", "C", [o](const std::string& t) { return take_clouds(t, o->make.clouds); },
      "collapsed (default), or R or R:SEED: knots drawn within\nR times the shortest edge");
  set.option(
      "--control", "RULE", [o](const std::string& t) { return take_control(t, o->make.control); },
      "greville (default): the identity; edges: points on the\nedges of the tetrahedra");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o]() -> std::string {
    if (!o->output) return "-o OUT.vdms is required, the file of the model";
    return o->degree ? "" : "--degree N is required, from 1 to 9";
  });
  return [o](StandardOutput& out) { return run_make(*o, out); };
}

}  // namespace veritope::cli
