// SPDX-License-Identifier: LGPL-3.0-or-later
// What reports say about the patches of spline files, for people.
#include <algorithm>
#include <cmath>

#include "interval/numeric.h"
#include "report/decimal_text.h"
#include "report/patch_report_internal.h"
#include "report/report_text.h"

namespace veritope::report {
namespace {

std::string parameters_text(const EntityPart& part) {
  const bool is_triangle = part.parameters.size() == 3 && !part.face && !part.is_of_volume;
  std::string out = "entity " + std::to_string(part.entity);
  if (part.side) out += ", side " + std::to_string(*part.side);
  constexpr const char* kNames[] = {"u", "v", "w"};
  for (std::size_t i = 0; i < part.parameters.size(); ++i) {
    const auto& [lo, hi] = part.parameters[i];
    const auto [begin, end] = range_ends(lo, hi, 10);
    out += std::string(i == 0 ? ": " : ", ") +
           (is_triangle ? "b" + std::to_string(i) : std::string(kNames[i])) +
           (lo == hi ? " = " + begin : " in [" + begin + ", " + end + "]");
  }
  return out;
}

std::string defect_details(const Finding& f) {
  std::string out = detail_line("defect", f.code + ": " + f.message);
  for (const EntityPart& part : f.place.parts) out += detail_line("", parameters_text(part));
  return out;
}

std::string bounds_text(const Interval& v) {
  const auto [lo, hi] = range_ends(v.lo(), v.hi(), 10);
  return lo == hi ? lo : "between " + lo + " and " + hi;
}

// A middle is said only of an enclosure that has one.
std::string volume_words(const Interval& v) {
  if (std::isfinite(v.lo()) && std::isfinite(v.hi())) return "about " + short_decimal(mid(v));
  if (v.lo() > 0) return "at least " + short_decimal(v.lo());
  return "not bounded";
}

std::string shells_text(const PatchFacts& r) {
  if (r.shell_facts.size() < 2) return "";
  std::string out;
  for (std::size_t i = 0; i < std::min(internal::kMostShown, r.shell_facts.size()); ++i) {
    const PatchShellFacts& s = r.shell_facts[i];
    out += detail_line("shell " + std::to_string(i),
                       std::string(s.is_outward ? "outward" : "inward") + ", genus " +
                           std::to_string(s.genus) + ", volume " + bounds_text(s.volume));
  }
  if (r.shell_facts.size() > internal::kMostShown)
    out += detail_line("...", std::to_string(r.shell_facts.size() - internal::kMostShown) +
                                  " more shells (--json lists them)");
  return out;
}

std::string place_text(const Box3d& box) { return "in the box " + box_text(box); }

std::string where_line(const Finding& finding) {
  const std::optional<Box3d>& box = finding.place.box;
  return box && is_finite(*box) ? detail_line("where", place_text(*box)) : "";
}

std::string reversed_text(const std::vector<std::uint64_t>& reversed) {
  if (reversed.empty()) return "";
  std::string list;
  for (std::size_t i = 0; i < std::min(internal::kMostShown, reversed.size()); ++i)
    list += (i == 0 ? "" : ", ") + std::to_string(reversed[i]);
  return detail_line("reversed", counted(reversed.size(), "entity", "entities") + ": " + list +
                                     (reversed.size() > internal::kMostShown ? ", ..." : ""));
}

std::string patch_file_text(const FileReport& report, const PatchFacts& f) {
  const auto& source = std::get<SplineSource>(report.source);
  std::string out = detail_line("file", std::string(spline_format_name(source.format)) + ", " +
                                            counted(source.bytes, "byte", "bytes") + ", " +
                                            counted(source.entities, "entity", "entities"));
  if (f.patches == 0) return out;
  return out + detail_line("patches", counted(f.patches, "patch", "patches") + ", " +
                                          counted(f.vertices, "vertex", "vertices") + ", " +
                                          counted(f.edges, "edge", "edges") + ", " +
                                          counted(f.shells, "shell", "shells"));
}

std::string valid_text(const PatchFacts& f) {
  std::string out = detail_line("proof", counted(f.boxes, "star box", "star boxes") + " (" +
                                             std::to_string(f.boxes_tried) + " tried)");
  if (f.volume) out += detail_line("volume", bounds_text(*f.volume));
  out += shells_text(f);
  return f.collar ? out + collar_text(*f.collar) : out;
}

std::string side_name(const EntityPart& part) {
  if (part.face) return parameters_text(part);
  return "side " + std::to_string(*part.side) + " of entity " + std::to_string(part.entity);
}

std::string open_side_text(const OpenSideFacts& f) {
  std::string out = "    " + parameters_text(f.part) + "\n      from " +
                    point_text(f.side.ends[0]) + " to " + point_text(f.side.ends[1]);
  if (f.near) out += "; " + short_decimal(f.side.distance, 2) + " from " + side_name(*f.near);
  return out + "\n";
}

std::string open_sides_text(const PatchFacts& f) {
  if (f.open_sides.empty()) return "";
  std::string out = "  " + counted(f.open.sides, "open side", "open sides") + ", longest first\n";
  for (const OpenSideFacts& side : f.open_sides) out += open_side_text(side);
  const std::uint64_t more = f.open.sides - f.open_sides.size();
  return more == 0 ? out : out + "    and " + std::to_string(more) + " more\n";
}

// Commands are not broken, so that they can be copied.
std::string help_text(const std::string& code, const PatchFacts& facts) {
  const std::string what = code == "side-direction" ? "patches so that their sides fit"
                           : code == "left-handed"  ? "such cells"
                                                    : "whole shells that face the wrong way";
  const std::string reversing = facts.auto_helps ? unbroken("veritope certify --orient auto FILE") +
                                                       " reverses " + what + "; "
                                                 : "";
  return detail_line("what helps", reversing + unbroken("veritope explain " + code));
}

std::string defects_text(const FileReport& report) {
  std::string out;
  for (const Finding& f : report.defects) out += defect_details(f);
  const PatchFacts& facts = internal::facts_of(report);
  return out + open_sides_text(facts) + help_text(report.defects.front().code, facts);
}

std::string reason_parts(const Finding& f) {
  std::string out = where_line(f);
  for (const EntityPart& part : f.place.parts)
    if (!part.parameters.empty()) out += detail_line("", parameters_text(part));
  return out;
}

// The first reason's message is in the summary.
std::string reasons_text(const std::vector<Finding>& reasons, const PatchFacts& facts) {
  if (reasons.empty() || reasons.front().code == "not-covered") return "";
  std::string out = reason_parts(reasons.front());
  for (std::size_t i = 1; i < std::min(internal::kMostShown, reasons.size()); ++i)
    out +=
        detail_line("also", reasons[i].code + ": " + reasons[i].message) + reason_parts(reasons[i]);
  if (reasons.size() > internal::kMostShown)
    out += detail_line("...", std::to_string(reasons.size() - internal::kMostShown) +
                                  " more reasons (--json lists them)");
  return out + help_text(reasons.front().code, facts);
}

// What is open, as a whole.
std::string open_text(const OpenBorders& open) {
  const std::string sides = counted(open.sides, "open side", "open sides") + " in " +
                            counted(open.borders, "border", "borders");
  if (open.near_sides == 0 && open.sheets != 0)
    return (open.sheets == 1 ? "an open sheet: " : std::to_string(open.sheets) + " open sheets: ") +
           sides + "; " + (open.sheets == 1 ? "it bounds" : "they bound") + " no solid";
  if (open.near_sides == 0) return sides;
  const auto [least, greatest] = range_ends(open.least, open.greatest, 2);
  const std::string distance = least == greatest ? greatest : least + " to " + greatest;
  return sides + ", " +
         (open.near_sides == open.sides ? "each" : std::to_string(open.near_sides) + " of them") +
         " within " + distance + " of another one";
}

}  // namespace

std::string collar_text(const CollarFacts& c) {
  if (c.open) return detail_line("collar", "none found: " + c.open->message) + where_line(*c.open);
  const bool is_even = c.coarsest_level == c.finest_level;
  return detail_line("coarsest collar",
                     counted(c.cells, "cell", "cells") + ", edge " +
                         short_decimal(c.shortest_edge) +
                         (is_even ? "" : " to " + short_decimal(c.longest_edge)) +
                         (is_even ? ", level " : ", levels ") + std::to_string(c.coarsest_level) +
                         (is_even ? "" : " to " + std::to_string(c.finest_level)));
}

namespace internal {

std::string patch_summary(const FileReport& report) {
  const std::string about = report.boundary_faces ? ", by boundary faces" : "";
  const PatchFacts& f = facts_of(report);
  if (!report.defects.empty() && report.defects.front().code == "side-open")
    return open_text(f.open) + about;
  if (!report.defects.empty()) return report.defects.front().message + about;
  std::string text = counted(f.bodies, "body", "bodies") + ", genus " + std::to_string(f.genus);
  if (f.volume) text += ", volume " + volume_words(*f.volume);
  return text + about;
}

std::string patch_findings(const FileReport& report, const TextOptions&) {
  return report.defects.empty() ? reasons_text(report.reasons, facts_of(report))
                                : defects_text(report);
}

std::string patch_details(const FileReport& report, const TextOptions&) {
  const PatchFacts& f = facts_of(report);
  const std::string out = patch_file_text(report, f) + reversed_text(f.reversed);
  return report.verdict == Verdict::kValid ? out + valid_text(f) : out;
}

}  // namespace internal
}  // namespace veritope::report
