// SPDX-License-Identifier: LGPL-3.0-or-later
// Intersections and their curves as JSON. The schema: docs/report.schema.json, intersection.
#include "report/intersection_report.h"
#include "report/json_text.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

template <std::size_t N>
Json interval_box_json(const Box<N>& box) {
  Json out = Json::array();
  for (const Interval& side : box) out.push_back(interval_json(side));
  return out;
}
Json surface_json(const NamedSurface& s) {
  return {{"entity", s.entity}, {"face", optional_json(s.face)}, {"trimmed", s.is_trimmed}};
}

Json branch_json(const IntersectionBranch& b) {
  Json boxes = Json::array();
  for (const CurveSegment& s : b.segments)
    boxes.push_back(
        {{"parameters", interval_box_json(s.parameters)}, {"space", interval_box_json(s.space)}});
  return {{"closed", b.is_closed},     {"partial", b.is_partial},
          {"num_boxes", b.num_boxes},  {"length", interval_json(b.length)},
          {"gap", number_json(b.gap)}, {"boxes", boxes}};
}

Json contact_json(const IntersectionContact& c, const SurfaceIntersection& in) {
  Json out = {{"parameters", interval_box_json(c.parameters)},
              {"space", interval_box_json(c.space)},
              {"num_boxes", c.num_boxes}};
  if (c.kind == IntersectionContact::Kind::kTangency) {
    out["shape"] = shape_name(c.shape);
    out["separation"] = interval_json(c.separation);
  }
  if (c.kind == IntersectionContact::Kind::kUnresolved) {
    out["reason"] = c.reason;
    out["spent"] = {{"pairs", in.pairs}, {"proofs", in.proofs}};
  }
  return out;
}

/// The elements of one list of all pairs, each with its surfaces.
template <typename List, typename ToJson>
Json all_of(const IntersectionReport& report, List list, ToJson to_json) {
  Json out = Json::array();
  for (const PairIntersection& p : report.pairs)
    for (const auto& element : list(p.found)) {
      Json one = {{"first", surface_json(p.first)}, {"second", surface_json(p.second)}};
      one.update(to_json(element, p.found));
      out.push_back(one);
    }
  return out;
}

Json head_json(const IntersectionReport& report, const char* schema) {
  Json files = Json::array();
  for (std::size_t k = 0; k < 2; ++k)
    files.push_back({{"path", report.paths[k]}, {"sha256", report.sha256[k]}});
  return {{"schema", schema}, {"tool", tool_name()}, {"files", files}};
}

}  // namespace

std::string intersection_json(const IntersectionReport& report) {
  Json out = head_json(report, "veritope-intersect-1");
  const auto contact = [](const IntersectionContact& c, const SurfaceIntersection& in) {
    return contact_json(c, in);
  };
  out["branches"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.branches; },
      [](const IntersectionBranch& b, const SurfaceIntersection&) { return branch_json(b); });
  out["overlaps"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.overlaps; }, contact);
  out["tangencies"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.tangencies; }, contact);
  out["unresolved"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.unresolved; }, contact);
  out["pairs_of_surfaces"] = report.num_pairs;
  out["trimming_ignored"] = report.ignores_trimming;
  out["triangles_ignored"] = report.ignored_triangles;
  out["complete"] = report.is_complete();
  return dump(out) + "\n";
}

std::string curves_json(const IntersectionReport& report) {
  Json out = head_json(report, "veritope-curves-1");
  out["curves"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.branches; },
      [](const IntersectionBranch& b, const SurfaceIntersection&) {
        Json segments = Json::array();
        for (const CurveSegment& s : b.segments) {
          Json points = Json::array();
          for (const Point4& p : s.control) points.push_back(Json(p));
          segments.push_back({{"control", points}, {"gap", number_json(s.gap)}});
        }
        return Json{{"closed", b.is_closed}, {"partial", b.is_partial}, {"segments", segments}};
      });
  return dump(out) + "\n";
}

}  // namespace veritope::report
