// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/classify_report.h"

#include "report/decimal_text.h"
#include "report/file_report.h"
#include "report/json_text.h"
#include "verify/certify/certify.h"

namespace veritope::report {

std::string classify_json(const ClassifyReport& report) {
  Json out, model, undecided = Json::array();
  model["path"] = report.path;
  model["sha256"] = report.sha256;
  model["verdict"] = report.verdict ? Json(verdict_word(report.verdict)) : Json(nullptr);
  for (const auto& u : report.undecided)
    undecided.push_back({{"line", u.line}, {"reason", u.reason}});
  out["schema"] = "veritope-classify-1";
  out["tool"] = tool_name();
  out["model"] = model;
  out["decimals"] = report.are_decimals_exact ? "exact" : "nearest";
  out["by"] = report.by;
  out["origin"] = nullptr;
  if (report.origin) {
    out["origin"] = Json::array();
    for (const Rational& x : *report.origin) out["origin"].push_back(fraction_text(x));
  }
  out["winding"] = report.is_winding;
  out["reversed"] = nullptr;
  if (report.reversed)
    out["reversed"] = {{"parts", report.reversed->parts},
                       {"total", report.reversed->total},
                       {"first", report.reversed->first}};
  out["counts"] = {{"points", report.points},
                   {"in", report.in},
                   {"on", report.on},
                   {"out", report.out},
                   {"undecided", report.num_undecided}};
  out["undecided"] = undecided;
  out["undecided_not_listed"] = report.num_undecided - report.undecided.size();
  out["lookup"] = {{"cells", report.lookup_cells}, {"bytes", report.lookup_bytes}};
  out["certificate"] = nullptr;
  if (report.certificate)
    out["certificate"] = {{"path", report.certificate->path},
                          {"bytes", report.certificate->bytes},
                          {"uncovered", report.certificate->uncovered},
                          {"checked", report.certificate->is_checked}};
  out["seconds"] = {{"read", seconds_json(report.seconds_read)},
                    {"build", seconds_json(report.seconds_build)},
                    {"classify", seconds_json(report.seconds_classify)}};
  return dump(out) + "\n";
}

}  // namespace veritope::report
