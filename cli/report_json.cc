// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/report_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/bounding_box.h"
#include "cli/certify.h"
#include "cli/decimal_text.h"
#include "cli/json_text.h"

namespace veritope::cli {
namespace {

constexpr std::size_t kMostShells = 100'000;  // listed; a soup of triangles has millions

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json number(double value) { return number_json(value); }

Json vector_json(const Vec3d& p) { return Json::array({p.x, p.y, p.z}); }

Json volume_json(const std::optional<Rational>& volume) {
  if (!volume) return nullptr;
  return {{"exact", fraction_text(*volume)}, {"decimal", scientific_text(*volume)}};
}

Json point_json(const RationalPoint& point) {
  Json exact = Json::array(), decimal = Json::array();
  for (const Rational& c : point.at) {
    exact.push_back(fraction_text(c));
    decimal.push_back(number(nearest_double(c)));
  }
  return {{"exact", exact}, {"decimal", decimal}};
}

Json counts_json(const FileReport& report) {
  Json out;
  const ReadReport* const r = report.reading ? &*report.reading : nullptr;
  const MeshCounts* const c = report.decision ? &report.decision->counts : nullptr;
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
  return out;
}

Json rules_json(const FileReport& report) {
  Json out;
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    const MeshRule rule = rule_at(i);
    const bool is_known = report.decision && (report.decision->nesting_decided ||
                                              (rule != MeshRule::kM8 && rule != MeshRule::kM9));
    out[std::string(rule_text(rule).id)] =
        is_known ? Json(report.decision->rule_counts[i]) : Json(nullptr);
  }
  return out;
}

Json shells_json(const FileReport& report) {
  Json out = Json::array();
  if (!report.decision) return out;
  for (const ShellReport& s : report.decision->shells) {
    if (out.size() == kMostShells) break;
    out.push_back({{"genus", optional_json(s.genus)},
                   {"euler", s.euler},
                   {"outward", optional_json(s.outward)},
                   {"depth", optional_json(s.depth)},
                   {"volume", volume_json(s.volume)}});
  }
  return out;
}

Json box_json(const Vec3d& lo, const Vec3d& hi) {
  return {{"min", vector_json(lo)}, {"max", vector_json(hi)}};
}

Json ignored_json(const ReadReport* report) {
  Json out = Json::array();
  if (report == nullptr) return out;
  for (const auto& [what, count] : report->ignored) {
    out.push_back({{"what", what}, {"count", count}});
  }
  return out;
}

Json notices_json(const ReadReport* report) {
  Json out = Json::array();
  if (report == nullptr) return out;
  for (const ReadNotice& n : report->notices)
    out.push_back({{"code", n.code}, {"message", n.message}});
  return out;
}

Json defect_json(const ListedDefect& listed) {
  const Defect& d = listed.defect;
  Json edges = Json::array();
  for (const auto& [a, b] : d.edges) edges.push_back(Json::array({a, b}));
  return {{"rule", std::string(rule_text(d.rule).id)},
          {"faces", d.faces},
          {"edges", edges},
          {"vertices", d.vertices},
          {"point", point_json(d.point)},
          {"size", number(d.size)},
          {"message", d.message},
          {"polygons", listed.polygons}};
}

}  // namespace

std::string report_json(const FileReport& report) {
  if (report.patches) return patch_report_json(report);
  const ReadReport* const r = report.reading ? &*report.reading : nullptr;
  Json defects = Json::array();
  for (const ListedDefect& d : report.defects) defects.push_back(defect_json(d));
  Json out;
  out["path"] = report.path;
  out["sha256"] = text_or_null(report.sha256);
  out["bytes"] = r != nullptr ? Json(r->bytes) : Json(nullptr);
  out["format"] = r != nullptr ? Json(mesh_format_name(r->format)) : Json(nullptr);
  out["variant"] = r != nullptr ? Json(r->variant) : Json(nullptr);
  out["as_indexed"] = report.as_indexed;
  out["verdict"] = verdict_name(report.verdict);
  out["exit"] = static_cast<int>(report.exit);
  out["error"] = fault_json(report.fault);
  out["counts"] = counts_json(report);
  out["rules"] = rules_json(report);
  out["shells"] = shells_json(report);
  out["volume"] = report.decision ? volume_json(report.decision->volume) : Json(nullptr);
  out["bbox"] =
      report.decision ? box_json(report.decision->box_lo, report.decision->box_hi) : Json(nullptr);
  out["ignored"] = ignored_json(r);
  out["notices"] = notices_json(r);
  out["defects_total"] = optional_json(total_defects(report));
  out["defects"] = std::move(defects);
  out["certificate"] = certificate_json(report.certificate);
  out["seconds"] = phases_json(report.seconds);
  return dump(out);
}

std::string info_json(const InfoReport& report) {
  const MeshFile* const file = report.file ? &*report.file : nullptr;
  const ReadReport* const r = file != nullptr ? &file->report : nullptr;
  const auto count = [r](std::uint64_t ReadReport::*member) {
    return r != nullptr ? Json(r->*member) : Json(nullptr);
  };
  Json out;
  out["path"] = report.path;
  out["sha256"] = file != nullptr ? Json(file->sha256) : Json(nullptr);
  out["bytes"] = count(&ReadReport::bytes);
  out["format"] = r != nullptr ? Json(mesh_format_name(r->format)) : Json(nullptr);
  out["variant"] = r != nullptr ? Json(r->variant) : Json(nullptr);
  out["as_indexed"] = report.as_indexed;
  out["exit"] = static_cast<int>(report.exit);
  out["error"] = fault_json(report.fault);
  out["counts"] = {
      {"vertices", count(&ReadReport::file_vertices)},
      {"faces", file != nullptr ? Json(file->mesh.faces.size()) : Json(nullptr)},
      {"distinct_vertices", count(&ReadReport::distinct_vertices)},
      {"referenced_vertices", count(&ReadReport::referenced_vertices)},
      {"unreferenced_vertices", count(&ReadReport::unreferenced_vertices)},
      {"polygons_split", count(&ReadReport::polygons_split)},
      {"strip_joints", count(&ReadReport::strip_joints)},
  };
  const Box box = file != nullptr ? bounding_box(file->mesh) : Box{};
  out["bbox"] = file != nullptr ? box_json(box.lo, box.hi) : Json(nullptr);
  out["ignored"] = ignored_json(r);
  out["notices"] = notices_json(r);
  out["lossless"] = report.lossless;
  out["seconds"] = {{"read", file != nullptr ? seconds_json(file->seconds_read) : Json(nullptr)},
                    {"parse", file != nullptr ? seconds_json(file->seconds_parse) : Json(nullptr)}};
  return dump(out);
}

std::string document_json(const std::string& schema, const std::vector<std::string>& files) {
  std::string out = "{\"schema\":\"" + schema + "\",\"tool\":\"" + tool_name() + "\",\"files\":[";
  for (std::size_t i = 0; i < files.size(); ++i) out += (i == 0 ? "\n" : ",\n") + files[i];
  return out + "\n]}\n";
}

}  // namespace veritope::cli
