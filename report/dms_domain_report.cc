// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_domain_report.h"

#include "report/json_text.h"
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

}  // namespace

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
  out["seconds"] = seconds_json(report.seconds);
  return dump(out) + "\n";
}

}  // namespace veritope::report
