// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/patch_report.h"

#include <algorithm>
#include <cmath>

#include "cli/decimal_text.h"
#include "cli/file_report.h"
#include "cli/json_text.h"
#include "cli/text_style.h"
#include "interval/numeric.h"

namespace veritope::cli {
namespace {

constexpr std::size_t kMostShells = 8;  // in text
constexpr std::size_t kMostShellsListed = 100'000;

Json bounds_json(const std::optional<Interval>& v) {
  if (!v) return nullptr;
  return {{"lo", number_json(v->lo())}, {"hi", number_json(v->hi())}};
}

// Some hulls have no bounds in binary64: then there is no place to show.
bool is_finite(const std::optional<Box3d>& box) {
  if (!box) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (!std::isfinite(box->lo[k]) || !std::isfinite(box->hi[k])) return false;
  return true;
}

Json box_json(const std::optional<Box3d>& box) {
  if (!is_finite(box)) return nullptr;
  const auto corner = [](const Point3d& p) {
    return Json::array({number_json(p[0]), number_json(p[1]), number_json(p[2])});
  };
  return {{"min", corner(box->lo)}, {"max", corner(box->hi)}};
}

Json part_json(const RefutedPart& part) {
  Json parameters = Json::array();
  for (const auto& [lo, hi] : part.parameters)
    parameters.push_back({{"lo", number_json(lo)}, {"hi", number_json(hi)}});
  return {{"entity", part.entity},
          {"side", optional_json(part.side)},
          {"parameters", std::move(parameters)}};
}

Json defect_json(const RefutationFacts& f) {
  Json parts = Json::array(), point = nullptr;
  for (const RefutedPart& part : f.parts) parts.push_back(part_json(part));
  if (f.point)
    point = {number_json((*f.point)[0]), number_json((*f.point)[1]), number_json((*f.point)[2])};
  return {{"code", f.code},
          {"message", f.message},
          {"parts", std::move(parts)},
          {"point", std::move(point)},
          {"box", box_json(f.box)},
          {"shell", optional_json(f.shell)},
          {"winding", optional_json(f.winding)}};
}

std::string parameters_text(const RefutedPart& part) {
  const bool is_triangle = part.parameters.size() == 3;
  std::string out = "entity " + std::to_string(part.entity);
  if (part.side) out += ", side " + std::to_string(*part.side);
  constexpr const char* kNames[] = {"u", "v"};
  for (std::size_t i = 0; i < part.parameters.size(); ++i) {
    const auto& [lo, hi] = part.parameters[i];
    out += std::string(i == 0 ? ": " : ", ") +
           (is_triangle ? "b" + std::to_string(i) : std::string(kNames[i])) +
           (lo == hi ? " = " + short_decimal(lo, 10)
                     : " in [" + short_decimal(lo, 10) + ", " + short_decimal(hi, 10) + "]");
  }
  return out;
}

std::string defect_details(const RefutationFacts& f) {
  std::string out = detail_line("defect", f.code + ": " + f.message);
  for (const RefutedPart& part : f.parts) out += detail_line("", parameters_text(part));
  return out;
}

Json collar_json(const std::optional<CollarReport>& c) {
  if (!c) return nullptr;
  Json out = {{"found", c->is_found}};
  if (!c->is_found) {
    out["message"] = c->message;
    out["place"] = box_json(c->place);
    return out;
  }
  out["cells"] = c->cells;
  out["levels"] = {{"coarsest", c->coarsest_level}, {"finest", c->finest_level}};
  out["edges"] = {{"longest", number_json(c->longest_edge)},
                  {"shortest", number_json(c->shortest_edge)}};
  return out;
}

std::string bounds_text(const Interval& v) {
  return "between " + short_decimal(v.lo(), 10) + " and " + short_decimal(v.hi(), 10);
}

// A middle is said only of an enclosure that has one.
std::string volume_words(const Interval& v) {
  if (std::isfinite(v.lo()) && std::isfinite(v.hi())) return "about " + short_decimal(mid(v));
  if (v.lo() > 0) return "at least " + short_decimal(v.lo());
  return "not bounded";
}

std::string shells_text(const PatchReport& r) {
  if (r.shell_facts.size() < 2) return "";
  std::string out;
  for (std::size_t i = 0; i < std::min(kMostShells, r.shell_facts.size()); ++i) {
    const PatchShellFacts& s = r.shell_facts[i];
    out += detail_line("shell " + std::to_string(i),
                       std::string(s.is_outward ? "outward" : "inward") + ", genus " +
                           std::to_string(s.genus) + ", volume " + bounds_text(s.volume));
  }
  if (r.shell_facts.size() > kMostShells)
    out += detail_line("...", std::to_string(r.shell_facts.size() - kMostShells) +
                                  " more shells (--json lists them)");
  return out;
}

std::string place_text(const Box3d& box) {
  const auto corner = [](const Point3d& p) {
    return "(" + short_decimal(p[0]) + ", " + short_decimal(p[1]) + ", " + short_decimal(p[2]) +
           ")";
  };
  return "in the box " + corner(box.lo) + " to " + corner(box.hi);
}

}  // namespace

std::string collar_text(const CollarReport& c) {
  if (!c.is_found) {
    std::string out = detail_line("collar", "none found: " + c.message);
    return is_finite(c.place) ? out + detail_line("where", place_text(*c.place)) : out;
  }
  const bool is_even = c.coarsest_level == c.finest_level;
  return detail_line("coarsest collar",
                     counted(c.cells, "cell", "cells") + ", edge " +
                         short_decimal(c.shortest_edge) +
                         (is_even ? "" : " to " + short_decimal(c.longest_edge)) +
                         (is_even ? ", level " : ", levels ") + std::to_string(c.coarsest_level) +
                         (is_even ? "" : " to " + std::to_string(c.finest_level)));
}

CollarReport collar_report(const PatchCollarSearch& search, const PieceForest& forest) {
  CollarReport out;
  if (!search.collar) {
    out.message = search.open.message;
    if (search.open.place) out.place = forest.in_model(*search.open.place);
    return out;
  }
  const OctreeKeySet& cells = search.collar->complex.cells();
  out.is_found = true;
  out.cells = cells.size();
  out.finest_level = cells.finest_level();
  out.coarsest_level = out.finest_level;
  for (const OctreeKey key : cells.keys())
    out.coarsest_level = std::min(out.coarsest_level, key.level());
  const double edge = std::ldexp(search.collar->root.edge(), -forest.scale());
  out.longest_edge = std::ldexp(edge, -static_cast<int>(out.coarsest_level));
  out.shortest_edge = std::ldexp(edge, -static_cast<int>(out.finest_level));
  return out;
}

std::string patch_report_json(const FileReport& report) {
  const PatchReport& r = *report.patches;
  const bool is_valid = report.verdict == FileVerdict::kValid;
  const auto if_valid = [&](std::uint64_t n) { return is_valid ? Json(n) : Json(nullptr); };
  Json out, shells = Json::array();
  for (std::size_t i = 0; i < std::min(kMostShellsListed, r.shell_facts.size()); ++i) {
    const PatchShellFacts& s = r.shell_facts[i];
    shells.push_back({{"genus", s.genus},
                      {"euler", s.euler},
                      {"outward", s.is_outward},
                      {"volume", bounds_json(s.volume)}});
  }
  out["path"] = report.path;
  out["sha256"] = report.sha256;
  out["bytes"] = r.bytes;
  out["format"] = spline_format_name(r.format);
  out["verdict"] = verdict_name(report.verdict);
  out["exit"] = static_cast<int>(report.exit);
  out["error"] = fault_json(report.fault);
  out["place"] = box_json(r.open ? r.open->place : std::nullopt);
  out["counts"] = {
      {"entities", r.entities},     {"patches", r.patches},       {"edges", r.edges},
      {"vertices", r.vertices},     {"shells", r.shells},         {"bodies", if_valid(r.bodies)},
      {"genus", if_valid(r.genus)}, {"boxes", if_valid(r.boxes)}, {"boxes_tried", r.boxes_tried}};
  out["defects"] = Json::array();
  for (const RefutationFacts& f : r.defects) out["defects"].push_back(defect_json(f));
  out["flipped"] = r.flipped;
  out["shells"] = std::move(shells);
  out["volume"] = bounds_json(r.volume);
  out["collar"] = collar_json(r.collar);
  out["certificate"] = certificate_json(report.certificate);
  out["seconds"] = phases_json(report.seconds);
  out["seconds"]["collar"] = seconds_json(report.seconds.collar);
  return dump(out);
}

std::string patch_summary(const PatchReport& r) {
  if (!r.defects.empty()) return r.defects.front().message;
  std::string text = counted(r.bodies, "body", "bodies") + ", genus " + std::to_string(r.genus);
  return r.volume ? text + ", volume " + volume_words(*r.volume) : text;
}

std::string patch_details(const FileReport& report) {
  const PatchReport& r = *report.patches;
  std::string out = detail_line("file", std::string(spline_format_name(r.format)) + ", " +
                                            counted(r.bytes, "byte", "bytes") + ", " +
                                            counted(r.entities, "entity", "entities"));
  if (r.patches != 0)
    out += detail_line("patches", counted(r.patches, "patch", "patches") + ", " +
                                      counted(r.vertices, "vertex", "vertices") + ", " +
                                      counted(r.edges, "edge", "edges") + ", " +
                                      counted(r.shells, "shell", "shells"));
  if (!r.flipped.empty()) {
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(8, r.flipped.size()); ++i)
      list += (i == 0 ? "" : ", ") + std::to_string(r.flipped[i]);
    out += detail_line("reversed", counted(r.flipped.size(), "entity", "entities") + ": " + list +
                                       (r.flipped.size() > 8 ? ", ..." : ""));
  }
  if (report.verdict == FileVerdict::kValid) {
    out += detail_line("proof", counted(r.boxes, "star box", "star boxes") + " (" +
                                    std::to_string(r.boxes_tried) + " tried)");
    if (r.volume) out += detail_line("volume", bounds_text(*r.volume));
    out += shells_text(r);
    if (r.collar) out += collar_text(*r.collar);
  } else if (!r.defects.empty()) {
    for (const RefutationFacts& f : r.defects) out += defect_details(f);
    out += detail_line("more", "veritope explain " + r.defects.front().code);
  } else if (r.open) {
    if (is_finite(r.open->place)) out += detail_line("where", place_text(*r.open->place));
    out += detail_line("more", "veritope explain not-certified");
  }
  return out;
}

}  // namespace veritope::cli
