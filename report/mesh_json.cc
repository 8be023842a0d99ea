// SPDX-License-Identifier: LGPL-3.0-or-later
// What reports say about meshes, as JSON.
#include <algorithm>
#include <numeric>
#include <utility>

#include "report/decimal_text.h"
#include "report/mesh_report_internal.h"

namespace veritope::report {
namespace {

using internal::decision_of;
using internal::reading_of;

Json volume_json(const std::optional<Rational>& volume) {
  if (!volume) return nullptr;
  return {{"exact", fraction_text(*volume)}, {"decimal", scientific_text(*volume)}};
}

Json exact_point_json(const RationalPoint& point) {
  Json exact = Json::array(), decimal = Json::array();
  for (const Rational& c : point.at) {
    exact.push_back(fraction_text(c));
    decimal.push_back(number_json(nearest_double(c)));
  }
  return {{"exact", exact}, {"decimal", decimal}};
}

Json counts_json(const FileReport& report) {
  Json out;
  const ReadReport* const r = reading_of(report);
  const ValidityReport* const decision = decision_of(report);
  const MeshCounts* const c = decision != nullptr ? &decision->counts : nullptr;
  const auto put = [&out](const char* name, const auto* from, auto member) {
    out[name] = from != nullptr ? Json(from->*member) : Json(nullptr);
  };
  put("vertices", r, &ReadReport::file_vertices);
  put("faces", c, &MeshCounts::faces);
  put("edges", c, &MeshCounts::edges);
  put("boundary_edges", c, &MeshCounts::boundary_edges);
  put("nonmanifold_edges", c, &MeshCounts::nonmanifold_edges);
  put("misoriented_edges", c, &MeshCounts::misoriented_edges);
  put("nonmanifold_vertices", c, &MeshCounts::nonmanifold_vertices);
  put("degenerate_faces", c, &MeshCounts::degenerate_faces);
  put("duplicate_faces", c, &MeshCounts::duplicate_faces);
  put("selfint_pairs", c, &MeshCounts::selfint_pairs);
  put("shells", c, &MeshCounts::shells);
  out["bodies"] = c != nullptr ? optional_json(c->bodies) : Json(nullptr);
  put("euler", c, &MeshCounts::euler);
  out["genus"] = c != nullptr ? optional_json(c->genus) : Json(nullptr);
  put("distinct_vertices", r, &ReadReport::distinct_vertices);
  put("referenced_vertices", r, &ReadReport::referenced_vertices);
  put("unreferenced_vertices", r, &ReadReport::unreferenced_vertices);
  put("polygons_split", r, &ReadReport::polygons_split);
  put("strip_joints", r, &ReadReport::strip_joints);
  const OpenEdges none, *open = nullptr;
  if (const auto* measured = internal::open_edges_of(report)) open = measured;
  if (c != nullptr && c->boundary_edges == 0) open = &none;
  put("borders", open, &OpenEdges::borders);
  put("near_edges", open, &OpenEdges::near_edges);
  put("unsearched_edges", open, &OpenEdges::unsearched_edges);
  out["near_distance"] = open != nullptr && open->near_edges != 0
                             ? Json{{"least", number_json(open->least_gap)},
                                    {"greatest", number_json(open->greatest_gap)}}
                             : Json(nullptr);
  return out;
}

Json rules_json(const FileReport& report) {
  Json out;
  const ValidityReport* const d = decision_of(report);
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    const MeshRule rule = rule_at(i);
    const bool is_known =
        d != nullptr && (d->nesting_decided || (rule != MeshRule::kM8 && rule != MeshRule::kM9));
    out[std::string(rule_text(rule).id)] = is_known ? Json(d->rule_counts[i]) : Json(nullptr);
  }
  return out;
}

Json shells_json(const FileReport& report) {
  Json out = Json::array();
  const ValidityReport* const d = decision_of(report);
  if (d == nullptr) return out;
  const Reversal* const reversal = internal::reversal_of(report);
  for (std::size_t i = 0; i < std::min(d->shells.size(), internal::kMostListed); ++i) {
    const ShellReport& s = d->shells[i];
    out.push_back({{"genus", optional_json(s.genus)},
                   {"euler", s.euler},
                   {"outward", optional_json(s.outward)},
                   {"depth", optional_json(s.depth)},
                   {"volume", volume_json(s.volume)},
                   {"reversed_faces", reversal != nullptr ? reversal->shells[i].reversed : 0}});
  }
  return out;
}

Json reversed_json(const Reversal* reversal) {
  if (reversal == nullptr) return nullptr;
  return {{"faces", reversal->faces},
          {"whole_shells", reversal->whole_shells},
          {"mixed_shells", reversal->mixed_shells}};
}

Json ends_json(const std::optional<std::array<RationalPoint, 2>>& ends) {
  if (!ends) return nullptr;
  return Json::array({exact_point_json(ends->at(0)), exact_point_json(ends->at(1))});
}

Json gap_json(const Witness& witness) {
  if (!witness.squared_gap) return nullptr;
  return {{"squared", fraction_text(*witness.squared_gap)},
          {"decimal", number_json(*witness.approx_distance)}};
}

Json mesh_defect_json(const Finding& d) {
  Json edges = Json::array();
  for (const auto& [a, b] : d.place.edges) edges.push_back(Json::array({a, b}));
  return {{"rule", d.code},
          {"faces", d.place.faces},
          {"edges", edges},
          {"vertices", d.place.vertices},
          {"point", exact_point_json(d.witness.point.value())},
          {"ends", ends_json(d.witness.ends)},
          {"size", number_json(d.place.size)},
          {"near_edge", d.place.near_edge
                            ? Json::array({d.place.near_edge->first, d.place.near_edge->second})
                            : Json(nullptr)},
          {"gap", gap_json(d.witness)},
          {"message", d.message},
          {"polygons", d.place.polygons}};
}

Json defects_total_json(const ValidityReport* decision) {
  if (decision == nullptr) return nullptr;
  const auto& counts = decision->rule_counts;
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

// Where faces meet improperly.
Json places_json(const ValidityReport* decision) {
  Json out = Json::array();
  if (decision == nullptr) return out;
  for (const ImproperPlace& p : decision->places) {
    if (out.size() == internal::kMostListed) break;
    out.push_back({{"count", p.pairs}, {"faces", p.faces}, {"box", box_json(p.box)}});
  }
  return out;
}

void put_mesh_source(const FileReport& report, Json& out) {
  const ReadReport* const r = reading_of(report);
  out["variant"] = r != nullptr ? Json(r->variant) : Json(nullptr);
  out["as_indexed"] = r != nullptr && r->as_indexed;
  out["copy"] = internal::copy_json(report.copy);
}

void put_mesh_facts(const FileReport& report, Json& out) {
  const ValidityReport* const decision = decision_of(report);
  Json defects = Json::array();
  for (const Finding& d : report.defects) defects.push_back(mesh_defect_json(d));
  out["counts"] = counts_json(report);
  out["rules"] = rules_json(report);
  out["shells"] = shells_json(report);
  out["reversed"] = reversed_json(internal::reversal_of(report));
  out["valid_once_reversed"] =
      decision != nullptr ? Json(is_valid_once_reversed(*decision)) : Json(nullptr);
  out["volume"] = decision != nullptr ? volume_json(decision->volume) : Json(nullptr);
  out["bbox"] = decision != nullptr ? box_json(decision->box) : Json(nullptr);
  out["ignored"] = internal::ignored_json(reading_of(report));
  out["notices"] = internal::notices_json(reading_of(report));
  out["places_total"] = decision != nullptr ? Json(decision->places.size()) : Json(nullptr);
  out["places"] = places_json(decision);
  out["defects_total"] = defects_total_json(decision);
  out["defects"] = std::move(defects);
}

}  // namespace

namespace internal {

Json ignored_json(const ReadReport* report) {
  Json out = Json::array();
  if (report == nullptr) return out;
  for (const auto& [what, count] : report->ignored) {
    out.push_back({{"what", what}, {"count", count}});
  }
  return out;
}

Json copy_json(const std::optional<CopyReport>& copy) {
  if (!copy) return nullptr;
  return {{"path", optional_json(copy->path)},
          {"sha256", copy->sha256},
          {"bytes", copy->bytes},
          {"what", copy->what},
          {"of_volumes", copy->is_of_volumes}};
}

Json notices_json(const ReadReport* report) {
  Json out = Json::array();
  if (report == nullptr) return out;
  for (const ReadNotice& n : report->notices)
    out.push_back({{"code", n.code}, {"message", n.message}});
  return out;
}

const ReadReport* reading_of(const FileReport& report) {
  return std::get_if<ReadReport>(&report.source);
}
const ValidityReport* decision_of(const FileReport& report) {
  const auto* const facts = std::get_if<MeshFacts>(&report.facts);
  return facts != nullptr ? &facts->decision : nullptr;
}

const OpenEdges* open_edges_of(const FileReport& report) {
  const auto* const facts = std::get_if<MeshFacts>(&report.facts);
  return facts != nullptr && facts->open_edges ? &*facts->open_edges : nullptr;
}
const Reversal* reversal_of(const FileReport& report) {
  const auto* const facts = std::get_if<MeshFacts>(&report.facts);
  return facts != nullptr && facts->reversal ? &*facts->reversal : nullptr;
}

const ReportKind kMeshReports = {put_mesh_source, put_mesh_facts, false,
                                 mesh_summary,    mesh_findings,  mesh_details};

}  // namespace internal
}  // namespace veritope::report
