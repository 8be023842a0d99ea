// SPDX-License-Identifier: LGPL-3.0-or-later
// What reports say about the patches of spline files, as JSON.
#include <algorithm>

#include "report/decimal_text.h"
#include "report/patch_report_internal.h"

namespace veritope::report {
namespace {

using internal::bounds_json;

Json part_json(const EntityPart& part) {
  Json parameters = Json::array();
  for (const auto& [lo, hi] : part.parameters)
    parameters.push_back({{"lo", number_json(lo)}, {"hi", number_json(hi)}});
  return {{"entity", part.entity},
          {"face", optional_json(part.face)},
          {"side", optional_json(part.side)},
          {"parameters", std::move(parameters)}};
}

Json parts_json(const Finding& f) {
  Json out = Json::array();
  for (const EntityPart& part : f.place.parts) out.push_back(part_json(part));
  return out;
}

Json exact_json(const std::array<Rational, 3>& numbers) {
  Json out = Json::array();
  for (const Rational& x : numbers) out.push_back(fraction_text(x));
  return out;
}

Json fold_json(const Finding& f) {
  if (!f.witness.fold) return nullptr;
  Json out = {{"entity", f.place.parts.front().entity}, {"places", Json::array()}};
  for (const FoldPoint& p : *f.witness.fold)
    out["places"].push_back({{"parameters", exact_json(p.parameters)},
                             {"point", exact_json(p.point.at)},
                             {"determinant", to_int(p.sign)}});
  return out;
}

Json patch_defect_json(const Finding& f) {
  return {{"code", f.code},
          {"message", f.message},
          {"parts", parts_json(f)},
          {"point", f.place.near ? point_json(*f.place.near) : Json(nullptr)},
          {"box", box_json(f.place.box)},
          {"shell", optional_json(f.place.shell)},
          {"winding", optional_json(f.witness.winding)},
          {"fold", fold_json(f)}};
}

// A null for each place of which something is not known.
Json places_json(const Finding& f, Json (*of_place)(const CellPlace&)) {
  Json out = Json::array();
  for (const CellPlace& p : f.witness.cells) out.push_back(of_place(p));
  return out;
}
Json box_of_parameters(const CellPlace& p) {
  if (!p.box) return nullptr;
  Json out = Json::array();
  for (const auto& [lo, hi] : *p.box)
    out.push_back(Json::array({fraction_text(lo), fraction_text(hi)}));
  return out;
}
Json vmodel_defect_json(const Finding& f) {
  return {{"code", f.code},
          {"message", f.message},
          {"cells", places_json(f, [](const CellPlace& p) { return Json(p.cell); })},
          {"parts", places_json(f, [](const CellPlace& p) { return Json(p.part); })},
          {"parameters", places_json(f,
                                     [](const CellPlace& p) {
                                       return p.parameters ? exact_json(*p.parameters)
                                                           : Json(nullptr);
                                     })},
          {"boxes", places_json(f, box_of_parameters)},
          {"point", f.witness.point ? exact_json(f.witness.point->at) : Json(nullptr)},
          {"fold", fold_json(f)}};
}

Json reason_json(const Finding& f) {
  return {{"code", f.code},
          {"message", f.message},
          {"parts", parts_json(f)},
          {"point", f.place.near ? point_json(*f.place.near) : Json(nullptr)},
          {"box", box_json(f.place.box)},
          {"approximate_distance",
           f.witness.approx_distance ? number_json(*f.witness.approx_distance) : Json(nullptr)}};
}

Json collar_json(const std::optional<CollarFacts>& c) {
  if (!c) return nullptr;
  Json out = {{"found", !c->open}};
  if (c->open) {
    out["code"] = c->open->code;
    out["message"] = c->open->message;
    out["place"] = box_json(c->open->place.box);
    return out;
  }
  out["cells"] = c->cells;
  out["levels"] = {{"coarsest", c->coarsest_level}, {"finest", c->finest_level}};
  out["edges"] = {{"longest", number_json(c->longest_edge)},
                  {"shortest", number_json(c->shortest_edge)}};
  return out;
}

Json shells_json(const PatchFacts& facts) {
  Json out = Json::array();
  for (std::size_t i = 0; i < std::min(internal::kMostListed, facts.shell_facts.size()); ++i) {
    const PatchShellFacts& s = facts.shell_facts[i];
    out.push_back({{"genus", s.genus},
                   {"euler", s.euler},
                   {"outward", s.is_outward},
                   {"volume", bounds_json(s.volume)}});
  }
  return out;
}

Json counts_json(const FileReport& report, const PatchFacts& f) {
  const bool is_valid = report.verdict == Verdict::kValid;
  const auto if_valid = [&](std::uint64_t n) { return is_valid ? Json(n) : Json(nullptr); };
  return {
      {"entities", std::get<SplineSource>(report.source).entities},
      {"patches", f.patches},
      {"edges", f.edges},
      {"vertices", f.vertices},
      {"shells", f.shells},
      {"bodies", if_valid(f.bodies)},
      {"genus", if_valid(f.genus)},
      {"boxes", if_valid(f.boxes)},
      {"boxes_tried", f.boxes_tried},
      {"open_sides", f.open.sides},
      {"borders", f.open.borders},
      {"near_sides", f.open.near_sides},
      {"near_distance", f.open.near_sides != 0 ? Json{{"least", number_json(f.open.least)},
                                                      {"greatest", number_json(f.open.greatest)}}
                                               : Json(nullptr)}};
}

// Null: it has a coordinate beyond binary64.
Json end_json(const Point3d& p) {
  const bool is_finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  return is_finite ? point_json(p) : Json(nullptr);
}

Json open_sides_json(const PatchFacts& f) {
  Json out = Json::array();
  for (const OpenSideFacts& s : f.open_sides)
    out.push_back({{"part", part_json(s.part)},
                   {"ends", Json::array({end_json(s.side.ends[0]), end_json(s.side.ends[1])})},
                   {"length", number_json(s.side.length)},
                   {"near", s.near ? part_json(*s.near) : Json(nullptr)},
                   {"distance", s.near ? number_json(s.side.distance) : Json(nullptr)}});
  return out;
}

}  // namespace

namespace internal {

Json bounds_json(const std::optional<Interval>& v) {
  if (!v) return nullptr;
  return {{"lo", number_json(v->lo())}, {"hi", number_json(v->hi())}};
}

void put_patch_source(const FileReport& report, Json& out) {
  out["by_boundary_faces"] = report.boundary_faces.has_value();
  out["copy"] = copy_json(report.copy);
}

void put_patch_facts(const FileReport& report, Json& out) {
  const PatchFacts& f = facts_of(report);
  out["place"] = box_json(report.fault ? report.fault->place.box : std::nullopt);
  out["counts"] = counts_json(report, f);
  out["defects"] = Json::array();
  for (const Finding& d : report.defects)
    out["defects"].push_back(f.vmodel && !d.witness.cells.empty() ? vmodel_defect_json(d)
                                                                  : patch_defect_json(d));
  out["reasons"] = Json::array();
  for (const Finding& r : report.reasons) out["reasons"].push_back(reason_json(r));
  out["open_sides"] = open_sides_json(f);
  out["flipped"] = f.reversed;
  out["shells"] = shells_json(f);
  out["volume"] = bounds_json(f.volume);
  out["collar"] = collar_json(f.collar);
}

const PatchFacts& facts_of(const FileReport& report) {
  static const PatchFacts kNone;
  const auto* const facts = std::get_if<PatchFacts>(&report.facts);
  return facts != nullptr ? *facts : kNone;
}

const ReportKind kPatchReports = {put_patch_source, put_patch_facts, true,
                                  patch_summary,    patch_findings,  patch_details};

}  // namespace internal
}  // namespace veritope::report
