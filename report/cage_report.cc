// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/cage_report.h"

#include "interval/numeric.h"
#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/patch_report_internal.h"
#include "report/text_style.h"
#include "verify/certify/certify.h"

namespace veritope::report {

namespace {

Json fit_json(const CageReport::Fit& fit) {
  Json stop, out;
  if (fit.stop_span) stop = {{"span", *fit.stop_span}, {"near", fit.stop_near}};
  out["vectors"] = fit.vectors;
  out["tensors"] = fit.has_tensors;
  out["degrees"] = {{"median", fit.median}, {"worst", fit.worst}, {"line", fit.worst_line}};
  out["steps"] = fit.steps;
  out["shortened"] = fit.shortened;
  out["stopped"] = stop;
  out["thickness_error"] = fit.thickness_error ? Json(*fit.thickness_error) : Json(nullptr);
  return out;
}

std::string fit_text(const CageReport::Fit& fit) {
  std::string text = "  follows " +
                     counted(fit.vectors, fit.has_tensors ? "tensor" : "vector",
                             fit.has_tensors ? "tensors" : "vectors") +
                     ": median " + short_decimal(fit.median) + " degrees, worst " +
                     short_decimal(fit.worst) + " (line " + std::to_string(fit.worst_line) + "), " +
                     counted(fit.steps, "step", "steps") + ", " + std::to_string(fit.shortened) +
                     " shortened\n";
  if (fit.stop_span) {
    const auto& s = *fit.stop_span;
    text += "  det J > 0 ended it in the span " + std::to_string(s[0]) + "," +
            std::to_string(s[1]) + "," + std::to_string(s[2]) + " near " +
            point_text(fit.stop_near) + "\n";
  }
  if (fit.thickness_error)
    text += "  thickness is the fourth coordinate, off by at most " +
            short_decimal(*fit.thickness_error) + "\n";
  return text;
}

}  // namespace

std::string cage_json(const CageReport& report) {
  const PatchFacts& f = report.facts;
  Json out, pull;
  if (report.pull) pull = {{"rounds", report.pull->rounds}, {"shortened", report.pull->shortened}};
  out["schema"] = "veritope-cage-1";
  out["tool"] = tool_name();
  out["kind"] = report.kind;
  out["input"] =
      report.path ? Json({{"path", *report.path}, {"sha256", report.sha256}}) : Json(nullptr);
  out["output"] = {{"path", report.output_path},
                   {"sha256", report.output_sha256},
                   {"bytes", report.output_bytes}};
  out["counts"] = {{"cells", f.vmodel->counts.cells},
                   {"control_points", report.control_points},
                   {"internal", f.vmodel->counts.internal},
                   {"boundary", f.vmodel->counts.boundary},
                   {"euler", f.vmodel->counts.euler},
                   {"shells", f.shells},
                   {"genus", f.genus}};
  out["regular"] = f.vmodel->singular.empty();
  out["volume"] = internal::bounds_json(f.volume);
  out["pull"] = pull;
  out["fit"] = report.fit ? fit_json(*report.fit) : Json(nullptr);
  out["angle_error"] = report.angle_error ? Json(report.angle_error->to_string()) : Json(nullptr);
  out["seconds"] = seconds_json(report.seconds);
  return dump(out) + "\n";
}

std::string cage_text(const CageReport& report) {
  const PatchFacts& f = report.facts;
  std::string text = "wrote  " + unbroken(harmless(report.output_path)) + "  " +
                     counted(f.vmodel->counts.cells, "cell", "cells") +
                     (f.vmodel->singular.empty() ? "" : ", not regular") + ", " +
                     counted(report.control_points, "control point", "control points") +
                     ", genus " + std::to_string(f.genus);
  if (f.vmodel->volume)
    text += ", volume " + short_decimal(*f.vmodel->volume);
  else if (f.volume)
    text += ", volume about " + short_decimal(mid(*f.volume));
  text += "\n";
  if (report.pull)
    text += "  pulled in " + counted(report.pull->rounds, "round", "rounds") + ", " +
            counted(report.pull->shortened, "step", "steps") + " shortened\n";
  if (report.fit) text += fit_text(*report.fit);
  if (report.angle_error && report.angle_error->sign() != Sign::kZero)
    text += "  the angle is within " + short_decimal(round_up(*report.angle_error)) + " degrees\n";
  return text;
}

}  // namespace veritope::report
