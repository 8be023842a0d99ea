// SPDX-License-Identifier: LGPL-3.0-or-later
// What reports say about files of volumes, the cells of V-models, beside what they say of the boundary.
#include <algorithm>
#include <array>

#include "report/decimal_text.h"
#include "report/patch_report_internal.h"
#include "report/report_text.h"

namespace veritope::report {
namespace {

using internal::facts_of;

const VModelFacts& vmodel_of(const FileReport& report) { return *facts_of(report).vmodel; }

const char* kind_word(VSingularity::Kind kind) {
  switch (kind) {
    case VSingularity::Kind::kCorner: return "corner";
    case VSingularity::Kind::kEdge: return "edge";
    case VSingularity::Kind::kFace: return "face";
    case VSingularity::Kind::kPoint: return "point";
    case VSingularity::Kind::kCurve: return "curve";
  }
  return "";
}

Json singular_json(const VModelFacts& facts) {
  Json out = Json::array();
  for (std::size_t i = 0; i < std::min(internal::kMostListed, facts.singular.size()); ++i) {
    const VSingularity& s = facts.singular[i];
    Json box = Json::array();
    for (const auto& [lo, hi] : s.box)
      box.push_back(Json::array({fraction_text(lo), fraction_text(hi)}));
    out.push_back({{"cell", s.cell}, {"box", std::move(box)}, {"kind", kind_word(s.kind)}});
  }
  return out;
}

void put_vmodel_facts(const FileReport& report, Json& out) {
  internal::put_patch_facts(report, out);
  const PatchFacts& f = facts_of(report);
  const VModelFacts& v = *f.vmodel;
  const bool is_valid = report.verdict == Verdict::kValid;
  Json& counts = out["counts"];
  counts["cells"] = v.counts.cells;
  counts["pieces"] = v.counts.pieces;
  counts["half_v_surfaces"] = v.counts.half_v_surfaces;
  counts["v_surfaces"] = v.counts.v_surfaces;
  counts["internal"] = v.counts.internal;
  counts["boundary"] = v.counts.boundary;
  counts["v_curves"] = v.counts.v_curves;
  counts["v_points"] = v.counts.v_points;
  counts["euler"] = v.counts.euler;
  out["regular"] = is_valid ? Json(v.singular.empty()) : Json(nullptr);
  out["singular"] = singular_json(v);
  out["reversed"] = v.reversed;
  if (f.volume) {
    Json volume = internal::bounds_json(f.volume);
    volume["exact"] = v.volume ? Json(fraction_text(*v.volume)) : Json(nullptr);
    out["volume"] = std::move(volume);
  }
}

std::string numbers_text(const std::vector<std::uint64_t>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < std::min(internal::kMostShown, numbers.size()); ++i)
    out += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  return out + (numbers.size() > internal::kMostShown ? ", ..." : "");
}

constexpr std::size_t kLongestVolume = 40;  // characters

// "1/2", and "3" for 3/1.
std::string exact_text(const Rational& v) {
  const std::string out = fraction_text(v);
  return out.ends_with("/1") ? out.substr(0, out.size() - 2) : out;
}

std::string singular_line(const VSingularity& s) {
  std::string out = std::string(kind_word(s.kind)) + " of cell " + std::to_string(s.cell) + ": ";
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& [lo, hi] = s.box[a];
    out += std::string(a == 0 ? "" : ", ") + "uvw"[a] +
           (lo == hi ? " = " + exact_text(lo)
                     : " in [" + exact_text(lo) + ", " + exact_text(hi) + "]");
  }
  return out;
}

std::string cells_text(const VModelFacts& f, bool is_valid) {
  const VCounts& n = f.counts;
  std::string out = detail_line("cells", counted(n.cells, "cell", "cells") + ", " +
                                             counted(n.v_surfaces, "V-surface", "V-surfaces") +
                                             " (" + std::to_string(n.internal) + " internal), " +
                                             counted(n.v_curves, "V-curve", "V-curves") + ", " +
                                             counted(n.v_points, "V-point", "V-points"));
  if (!f.reversed.empty())
    out += detail_line(
        "reversed", counted(f.reversed.size(), "cell", "cells") + ": " + numbers_text(f.reversed));
  if (!is_valid || f.singular.empty()) return out;
  out += detail_line("singular", "the Jacobian determinant is zero on " +
                                     counted(f.singular.size(), "part", "parts") + " of cells");
  for (std::size_t i = 0; i < std::min(internal::kMostShown, f.singular.size()); ++i)
    out += detail_line("", singular_line(f.singular[i]));
  if (f.singular.size() > internal::kMostShown)
    out += detail_line("...", std::to_string(f.singular.size() - internal::kMostShown) +
                                  " more parts (--json lists them)");
  return out;
}

std::string vmodel_summary(const FileReport& report) {
  const std::string out = internal::patch_summary(report);
  if (report.verdict != Verdict::kValid) return out;
  const VModelFacts& f = vmodel_of(report);
  return counted(f.counts.cells, "cell", "cells") + (f.singular.empty() ? "" : ", not regular") +
         ", " + out;
}

std::string vmodel_details(const FileReport& report, const TextOptions& options) {
  const VModelFacts& f = vmodel_of(report);
  const bool is_valid = report.verdict == Verdict::kValid;
  std::string out = internal::patch_details(report, options) + cells_text(f, is_valid);
  if (f.volume && is_valid && exact_text(*f.volume).size() <= kLongestVolume)
    out += detail_line("exact volume", exact_text(*f.volume));
  return out;
}

}  // namespace

namespace internal {

const ReportKind kVModelReports = {put_patch_source, put_vmodel_facts, true,
                                   vmodel_summary,   patch_findings,   vmodel_details};

}  // namespace internal
}  // namespace veritope::report
