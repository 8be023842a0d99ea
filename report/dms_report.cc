// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_report.h"

#include <array>
#include <charconv>
#include <system_error>

#include "report/decimal_text.h"
#include "report/dms_defects_json.h"
#include "report/json_text.h"
#include "robust/base/check.h"
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
Json bound_json(double x) { return number_json(x); }

template <typename Rows, typename Number>
Json gradient_json(const Rows& gradient, Number number) {
  return each_json(gradient, [&](const auto& row) { return each_json(row, number); });
}

std::string point_json_text(const DmsPointReport& point) {
  Json out;
  out["tetrahedron"] = optional_json(point.tetrahedron);
  out["exact"] = each_json(point.value, exact_json);
  out["gradient"] = gradient_json(point.gradient, exact_json);
  out["lo"] = each_json(point.lo, bound_json);
  out["hi"] = each_json(point.hi, bound_json);
  out["gradient_lo"] = gradient_json(point.gradient_lo, bound_json);
  out["gradient_hi"] = gradient_json(point.gradient_hi, bound_json);
  return dump(out);
}

// As scientific_text writes it.
std::string number_text(double x) {
  std::array<char, 40> text;
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::scientific, 16);
  VT_CHECK(error == std::errc(), "a number has at most 24 characters");
  return {text.data(), end};
}

}  // namespace

std::string dms_eval_json(const DmsEvalReport& report) {
  Json out;
  out["schema"] = "veritope-dms-eval-1";
  out["tool"] = tool_name();
  out["model"] = {{"path", report.path}, {"sha256", report.sha256}, {"bytes", report.bytes}};
  out["degree"] = report.degree;
  out["attributes"] = report.attributes;
  out["defects"] = dms_defects_json(report.defects);
  out["seconds"] = seconds_json(report.seconds);
  std::string text = dump(out);
  text.pop_back();  // the brace
  text += ", \"points\": [";
  bool is_first = true;
  for (const DmsPointReport& point : report.points) {
    text += (is_first ? "\n" : ",\n") + point_json_text(point);
    is_first = false;
  }
  return text + "]}\n";
}

std::string dms_point_text(const DmsPointReport& point) {
  if (!point.tetrahedron) return "outside\n";
  std::string text;
  const auto add = [&](const std::string& number) {
    if (!text.empty()) text += ' ';
    text += number;
  };
  for (const Rational& r : point.value) add(fraction_text(r));
  for (const double x : point.number) add(number_text(x));
  return text + "\n";
}

}  // namespace veritope::report
