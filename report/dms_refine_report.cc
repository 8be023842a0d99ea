// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_refine_report.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "report/decimal_text.h"
#include "report/dms_defects_json.h"
#include "report/text_style.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

const char* simplex_name(const DmsCut& cut) {
  return std::array{"edge", "face", "tetrahedron"}.at(cut.simplex.size() - 2);
}
std::string component_name(const DmsModel& model, std::size_t component) {
  if (component < model.num_coordinates) return std::array{"x", "y", "z"}.at(component);
  return model.attributes[component - model.num_coordinates];
}

void put_insertion(const DmsInsertion& insertion, Json& out) {
  const DmsModel& model = insertion.model;
  out["on"] = simplex_name(insertion.cut);
  out["simplex"] = insertion.cut.simplex;
  out["cut"] = insertion.cut.tetrahedra;
  out["vertex"] = model.clouds.size() - 1;
  out["tetrahedra"] = model.tetrahedra.size();
  out["control_points"] = model.num_control();
  if (insertion.change.empty()) return;
  Json& change = out["change"] = Json::array();
  for (std::size_t c = 0; c < insertion.change.size(); ++c)
    change.push_back({{"of", component_name(model, c)},
                      {"lo", number_json(round_down(insertion.change[c].lo))},
                      {"hi", number_json(round_up(insertion.change[c].hi))}});
}

}  // namespace

bool is_within(const DmsInsertion& insertion, const Rational& max_change) {
  return std::ranges::all_of(insertion.change,
                             [&](const DmsChange& change) { return change.hi <= max_change; });
}

std::string dms_refine_json(const DmsRefineReport& report) {
  Json out;
  out["schema"] = "veritope-dms-refine-1";
  out["tool"] = tool_name();
  out["model"] = {{"path", report.path}, {"sha256", report.sha256}, {"bytes", report.bytes}};
  out["output"] = report.output;
  Json& at = out["at"] = Json::array();
  for (const Rational& c : report.at) at.push_back(fraction_text(c));
  out["max_change"] = report.max_change ? Json(fraction_text(*report.max_change)) : Json(nullptr);
  out["defects"] = dms_defects_json(report.defects);
  out["seconds"] = seconds_json(report.seconds);
  out["written"] = report.is_written;
  for (const char* key :
       {"on", "simplex", "cut", "vertex", "tetrahedra", "control_points", "change"})
    out[key] = nullptr;
  if (report.insertion) put_insertion(*report.insertion, out);
  return dump(out) + "\n";
}

std::string dms_refine_text(const DmsRefineReport& report) {
  const DmsInsertion& insertion = *report.insertion;
  const DmsModel& model = insertion.model;
  std::string place;
  if (insertion.cut.simplex.size() == 4) {
    place = " in tetrahedron " + std::to_string(insertion.tetrahedron);
  } else {
    place = std::string(" on the ") + simplex_name(insertion.cut) + " of the vertices ";
    for (std::size_t i = 0; i < insertion.cut.simplex.size(); ++i)
      place += (i == 0 ? "" : ", ") + std::to_string(insertion.cut.simplex[i]);
    place += " of " + counted(insertion.cut.tetrahedra.size(), "tetrahedron", "tetrahedra");
  }
  std::string text = (report.is_written ? "wrote  " : "not written  ") +
                     unbroken(harmless(report.output)) + "  vertex " +
                     std::to_string(model.clouds.size() - 1) + place + ", " +
                     counted(model.tetrahedra.size(), "tetrahedron", "tetrahedra") + ", " +
                     counted(model.num_control(), "control point", "control points") + "\n";
  for (std::size_t c = 0; c < insertion.change.size(); ++c) {
    const DmsChange& change = insertion.change[c];
    if (change.hi.sign() == Sign::kZero) continue;
    text += "  " + harmless(component_name(model, c)) + " changes by at most " +
            short_decimal(round_up(change.hi), 3) + ", at some point by " +
            short_decimal(round_down(change.lo), 3) + "\n";
  }
  return text;
}

}  // namespace veritope::report
