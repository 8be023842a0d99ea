// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_report.h"

#include <array>
#include <charconv>
#include <string>
#include <system_error>
#include <utility>

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

std::string dms_iso_json(const DmsIsoReport& report) {
  const auto& iso = report.iso;
  Json out;
  out["schema"] = "veritope-dms-iso-1";
  out["tool"] = tool_name();
  out["model"] = {{"path", report.path}, {"sha256", report.sha256}, {"bytes", report.bytes}};
  out["attribute"] = report.attribute;
  out["level"] = fraction_text(report.level);
  out["within"] = fraction_text(report.within);
  out["space"] = report.in_solid ? "solid" : "domain";
  out["defects"] = dms_defects_json(report.defects);
  out["seconds"] = seconds_json(report.seconds);
  out["certified"] = iso && iso->certified;
  out["obstacle"] = iso ? optional_json(iso->obstacle) : Json(nullptr);
  out["components"] = iso ? Json(iso->components) : Json(nullptr);
  out["euler"] = iso ? Json(iso->euler) : Json(nullptr);
  out["vertices"] = iso ? Json(iso->mesh.positions.size()) : Json(nullptr);
  out["triangles"] = iso ? Json(iso->mesh.faces.size()) : Json(nullptr);
  out["cells"] = iso ? Json(iso->cells) : Json(nullptr);
  out["num_undecided"] = iso ? Json(iso->num_undecided) : Json(nullptr);
  Json& undecided = out["undecided"] = Json::array();
  if (iso)
    for (const DmsIsoCell& cell : iso->undecided) {
      Json corners = Json::array();
      for (const DmsPoint& p : cell.corners) corners.push_back(each_json(p, exact_json));
      undecided.push_back({{"tetrahedron", cell.tetrahedron},
                           {"corners", std::move(corners)},
                           {"why", doubt_name(cell.why)}});
    }
  return dump(out) + "\n";
}

}  // namespace veritope::report
