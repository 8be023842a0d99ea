// SPDX-License-Identifier: LGPL-3.0-or-later
// Reports of certify about simplex-spline solids: tetrahedra, shells, what is proved wrong, and the condition of their
// certificate that is not proved.
#include <algorithm>

#include "interval/numeric.h"
#include "report/decimal_text.h"
#include "report/patch_report_internal.h"
#include "report/report_kinds_internal.h"

namespace veritope::report {
namespace {

const DmsFacts& dms_of(const FileReport& report) { return std::get<DmsFacts>(report.facts); }

void put_dms_source(const FileReport&, Json&) {}

Json dms_reason_json(const Finding& f) { return {{"code", f.code}, {"message", f.message}}; }

Json exact_json(const std::array<Rational, 3>& p) {
  Json out = Json::array();
  for (const Rational& c : p) out.push_back(fraction_text(c));
  return out;
}
Json dms_defect_json(const Finding& f, const DmsDefectFacts& facts) {
  const auto& at = facts.parameters;
  Json tetrahedra = Json::array();
  for (const std::uint32_t t : facts.tetrahedra) tetrahedra.push_back(t);
  return {{"code", f.code},
          {"message", f.message},
          {"tetrahedra", std::move(tetrahedra)},
          {"beta", facts.beta ? Json(*facts.beta) : Json(nullptr)},
          {"parameter", at.empty() ? Json(nullptr) : exact_json(at[0])},
          {"other_parameter", at.size() < 2 ? Json(nullptr) : exact_json(at[1])},
          {"value", facts.value ? Json(fraction_text(*facts.value)) : Json(nullptr)}};
}
Json dms_defects_json(const FileReport& report) {
  const DmsFacts& f = dms_of(report);
  Json out = Json::array();
  for (std::size_t i = 0; i < std::min(report.defects.size(), f.defects.size()); ++i)
    out.push_back(dms_defect_json(report.defects[i], f.defects[i]));
  return out;
}

void put_dms_facts(const FileReport& report, Json& out) {
  const DmsFacts& f = dms_of(report);
  const bool is_valid = report.verdict == Verdict::kValid;
  const auto if_valid = [&](auto number) { return is_valid ? Json(number) : Json(nullptr); };
  out["counts"] = {{"tetrahedra", f.tetrahedra},
                   {"control_points", f.control_points},
                   {"degree", f.degree},
                   {"leaves", if_valid(f.leaves)},
                   {"patches", f.faces > 0 ? Json(nullptr) : if_valid(f.patches)},
                   {"faces", f.faces > 0 ? Json(f.faces) : Json(nullptr)},
                   {"bodies", if_valid(f.bodies)},
                   {"defects", f.num_defects}};
  out["defects"] = dms_defects_json(report);
  out["reasons"] = Json::array();
  for (const Finding& r : report.reasons) out["reasons"].push_back(dms_reason_json(r));
  out["shells"] = Json::array();
  if (is_valid)
    for (const std::uint64_t genus : f.genera) out["shells"].push_back({{"genus", genus}});
  out["volume"] = is_valid ? internal::bounds_json(f.volume) : Json(nullptr);
}

std::string dms_summary(const FileReport& report) {
  const DmsFacts& f = dms_of(report);
  if (!report.defects.empty())
    return harmless(report.defects.front().code + ": " + report.defects.front().message);
  std::uint64_t genus = 0;
  for (const std::uint64_t g : f.genera) genus += g;
  return counted(f.bodies, "body", "bodies") + ", genus " + std::to_string(genus) +
         (f.volume ? ", volume about " + short_decimal(mid(*f.volume), 6) : "");
}

// The first defect is in the summary.
std::string dms_findings(const FileReport& report, const TextOptions&) {
  const std::uint64_t all = dms_of(report).num_defects;
  std::string out;
  const std::size_t shown = std::min(internal::kMostShown, report.defects.size());
  for (std::size_t i = 1; i < shown; ++i)
    out += detail_line("also", harmless(report.defects[i].code + ": " + report.defects[i].message));
  if (shown > 0 && all > shown)
    out += detail_line("...", counted(all - shown, "more defect", "more defects"));
  return out;
}

std::string dms_details(const FileReport& report, const TextOptions&) {
  const auto& source = std::get<PlainSource>(report.source);
  const DmsFacts& f = dms_of(report);
  std::string out =
      detail_line("file", source.format + ", " + counted(source.bytes, "byte", "bytes")) +
      detail_line("solid", counted(f.tetrahedra, "tetrahedron", "tetrahedra") + ", " +
                               counted(f.control_points, "control point", "control points") +
                               ", degree " + std::to_string(f.degree));
  if (report.verdict != Verdict::kValid) return out;
  return out +
         detail_line("proof", counted(f.leaves, "leaf", "leaves") + ", " +
                                  (f.faces > 0 ? "pairs of " + counted(f.faces, "face", "faces")
                                               : counted(f.patches, "patch", "patches")) +
                                  " of the surface");
}

}  // namespace

const internal::ReportKind internal::kDmsReports = {put_dms_source, put_dms_facts, false,
                                                    dms_summary,    dms_findings,  dms_details};

}  // namespace veritope::report
