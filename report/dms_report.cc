// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_report.h"

#include "report/decimal_text.h"
#include "report/json_text.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

// The numbers of a list as `number` writes each; null for an empty list.
template <typename List, typename Number>
Json each_json(const List& list, Number number) {
  if (list.empty()) return nullptr;
  Json out = Json::array();
  for (const auto& item : list) out.push_back(number(item));
  return out;
}

Json exact_json(const Rational& r) { return fraction_text(r); }
Json low_json(const Rational& r) { return number_json(round_down(r)); }
Json high_json(const Rational& r) { return number_json(round_up(r)); }

template <typename Number>
Json gradient_json(const std::vector<std::array<Rational, 3>>& gradient, Number number) {
  return each_json(gradient, [&](const auto& row) { return each_json(row, number); });
}

std::string point_json_text(const DmsPointReport& point, bool is_exact) {
  const std::vector<Rational> none;
  const std::vector<std::array<Rational, 3>> no_gradient;
  const auto& exact = is_exact ? point.value : none;
  const auto& enclosed = is_exact ? none : point.value;
  const auto& exact_gradient = is_exact ? point.gradient : no_gradient;
  const auto& enclosed_gradient = is_exact ? no_gradient : point.gradient;
  Json out;
  out["tetrahedron"] = optional_json(point.tetrahedron);
  out["exact"] = each_json(exact, exact_json);
  out["gradient"] = gradient_json(exact_gradient, exact_json);
  out["lo"] = each_json(enclosed, low_json);
  out["hi"] = each_json(enclosed, high_json);
  out["gradient_lo"] = gradient_json(enclosed_gradient, low_json);
  out["gradient_hi"] = gradient_json(enclosed_gradient, high_json);
  return dump(out);
}

Json defects_json(const DmsDefects& defects) {
  Json out = Json::array();
  for (const DmsDefect& defect : defects.first) {
    Json one;
    one["code"] = fault_name(defect.fault);
    one["message"] = to_string(defect);
    one["tetrahedra"] = defect.tetrahedra;
    one["beta"] = defect.has_beta() ? Json(defect.beta) : Json(nullptr);
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace

std::string dms_eval_json(const DmsEvalReport& report) {
  Json out;
  out["schema"] = "veritope-dms-eval-1";
  out["tool"] = tool_name();
  out["model"] = {{"path", report.path}, {"sha256", report.sha256}, {"bytes", report.bytes}};
  out["degree"] = report.degree;
  out["attributes"] = report.attributes;
  out["defects"] = defects_json(report.defects);
  out["seconds"] = seconds_json(report.seconds);
  std::string text = dump(out);
  text.pop_back();  // the brace
  text += ", \"points\": [";
  bool is_first = true;
  for (const DmsPointReport& point : report.points) {
    text += (is_first ? "\n" : ",\n") + point_json_text(point, report.is_exact);
    is_first = false;
  }
  return text + "]}\n";
}

std::string dms_point_text(const DmsPointReport& point, bool is_exact) {
  if (!point.tetrahedron) return "outside\n";
  std::string text;
  for (const Rational& r : point.value)
    text += (text.empty() ? "" : " ") + (is_exact ? fraction_text(r) : scientific_text(r));
  return text + "\n";
}

}  // namespace veritope::report
