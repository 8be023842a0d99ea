// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_domain_report.h"

#include <algorithm>

#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/text_style.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

Json classes_json(const std::vector<DmsDomainVertex>& classes) {
  Json out = Json::array();
  for (const DmsDomainVertex& v : classes)
    out.push_back({{"vertex", v.vertex},
                   {"vertex_class", v.used},
                   {"vertex_class_paper", v.paper},
                   {"solid_angle", number_json(v.solid_angle)}});
  return out;
}

Json removals_json(const std::vector<DmsDomainRemoval>& removed) {
  Json out = Json::array();
  for (const DmsDomainRemoval& r : removed)
    out.push_back({{"points", r.points}, {"why", r.reason}});
  return out;
}

constexpr std::size_t kMostListed = 1000;

Json refinement_json(const DmsDomainRefinement& r) {
  Json angles = Json::array(), tetrahedra = Json::array();
  for (std::size_t i = 0; i < std::min(r.small_angles.size(), kMostListed); ++i)
    angles.push_back({{"vertices", r.small_angles[i].vertices},
                      {"dihedral", r.small_angles[i].is_dihedral},
                      {"degrees", number_json(r.small_angles[i].degrees)}});
  for (std::size_t i = 0; i < std::min(r.protected_tetrahedra.size(), kMostListed); ++i)
    tetrahedra.push_back(r.protected_tetrahedra[i]);
  return {{"max_volume", optional_json(r.max_volume)},
          {"max_radius_edge", optional_json(r.max_radius_edge)},
          {"max_points", r.max_points},
          {"inserted", r.inserted},
          {"taken_away", r.taken_away},
          {"end", r.end},
          {"over_volume", r.over_volume},
          {"over_radius_edge", r.over_radius_edge},
          {"largest_volume", number_json(r.largest_volume)},
          {"largest_radius_edge", number_json(r.largest_radius_edge)},
          {"protected", r.protected_tetrahedra.size()},
          {"protected_tetrahedra", std::move(tetrahedra)},
          {"small_angles", r.small_angles.size()},
          {"small_angle_list", std::move(angles)}};
}

}  // namespace

std::string dms_refinement_text(const DmsDomainReport& report) {
  const DmsDomainRefinement& r = *report.refinement;
  std::string text;
  if (r.end != "limits") {
    text += "  the limits are not reached: ";
    if (r.over_volume > 0)
      text += counted(r.over_volume, "tetrahedron is", "tetrahedra are") +
              " too large, up to a volume of " + short_decimal(r.largest_volume);
    if (r.over_radius_edge > 0)
      text += (r.over_volume > 0 ? "; " : "") +
              counted(r.over_radius_edge, "tetrahedron is", "tetrahedra are") + " too long";
    text += r.end == "budget" ? "; no more than " + std::to_string(r.max_points) +
                                    " vertices may be added (--max-points)\n"
                              : "; no place for a further vertex was found\n";
  }
  if (!r.protected_tetrahedra.empty())
    text += "  between small angles of the boundary " +
            counted(r.protected_tetrahedra.size(), "tetrahedron stays", "tetrahedra stay") +
            " too long, up to a ratio of " + short_decimal(r.largest_radius_edge) + "\n";
  return text;
}

std::string dms_domain_json(const DmsDomainReport& report) {
  Json out;
  out["schema"] = "veritope-dms-domain-1";
  out["tool"] = tool_name();
  out["input"] = report.input;
  out["output"] = {{"path", report.path}, {"sha256", report.sha256}, {"bytes", report.bytes}};
  out["points"] = report.points;
  out["duplicates"] = report.duplicates;
  out["vertices"] = report.vertices;
  out["tetrahedra"] = report.tetrahedra;
  out["steiner"] = report.steiner;
  out["delaunay"] = report.is_delaunay;
  out["min_dihedral"] = number_json(report.min_dihedral);
  out["classes"] = classes_json(report.classes);
  out["feature_lines"] = report.feature_lines;
  out["removed"] = removals_json(report.removed);
  out["filled"] = report.filled;
  out["refinement"] = report.refinement ? refinement_json(*report.refinement) : Json(nullptr);
  out["seconds"] = seconds_json(report.seconds);
  return dump(out) + "\n";
}

}  // namespace veritope::report
