// SPDX-License-Identifier: LGPL-3.0-or-later
// Spline reports for people.
#include <algorithm>
#include <array>

#include "report/decimal_text.h"
#include "report/file_report.h"
#include "report/spline_report.h"

namespace veritope::report {
namespace {

constexpr std::size_t kMostEntities = 20;

std::string box_text(const std::vector<ExactInterval>& box) {
  std::string lo, hi;
  for (const ExactInterval& s : box) {
    const auto [least, greatest] = range_ends(s.lo, s.hi);
    lo += (lo.empty() ? "" : ", ") + least;
    hi += (hi.empty() ? "" : ", ") + greatest;
  }
  return box.empty() ? "empty" : "(" + lo + ") to (" + hi + ")";
}

template <std::size_t N>
std::string map_text(const BSpline<Rational, N>& s) {
  std::string degrees, points;
  bool is_periodic = false;
  for (const auto& axis : s.axes()) {
    degrees += (degrees.empty() ? "" : "x") + std::to_string(axis.degree);
    points += (points.empty() ? "" : "x") + std::to_string(axis.num_control());
    is_periodic = is_periodic || axis.is_periodic;
  }
  return std::string(N == 1 ? "degree " : "degrees ") + degrees + ", " + points +
         " control points" + (s.is_rational() ? ", rational" : "") +
         (is_periodic ? ", periodic" : "") + ", dimension " + std::to_string(s.dimension());
}

std::string triangle_text(const ExactTriangle& t) {
  return "degree " + std::to_string(t.degree()) + ", " + std::to_string(t.count()) +
         " control points" + (t.is_rational() ? ", rational" : "") + ", dimension " +
         std::to_string(t.dimension());
}

std::string shape_text(const SplineEntity& e) {
  if (const auto* t = std::get_if<TrimmedSurface>(&e.shape))
    return map_text(t->surface) + ", " + counted(t->loops.size(), "loop", "loops");
  if (const auto* b = std::get_if<SplineBrep>(&e.shape))
    return counted(b->faces.size(), "surface", "surfaces") + ", " +
           counted(b->segments.size(), "segment", "segments");
  if (const auto* t = std::get_if<ExactTriangle>(&e.shape)) return triangle_text(*t);
  std::string text;
  for_each_spline(e, [&](const auto& s) { text = map_text(s); });
  return text;
}

std::string counts_text(const SplineModel& model) {
  constexpr std::array<std::array<const char*, 2>, 6> kNouns = {
      {{"curve", "curves"},
       {"surface", "surfaces"},
       {"volume", "volumes"},
       {"trimmed surface", "trimmed surfaces"},
       {"model", "models"},
       {"Bezier triangle", "Bezier triangles"}}};
  std::array<std::uint64_t, 6> counts{};
  for (const SplineEntity& e : model.entities) ++counts[e.shape.index()];
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] != 0)
      text += (text.empty() ? "" : ", ") + counted(counts[i], kNouns[i][0], kNouns[i][1]);
  return text.empty() ? "no splines" : text;
}

std::string name_text(const SplineModel& model, const SplineEntity& e) {
  for (auto g = e.group; g; g = model.groups[*g].parent)
    if (!model.groups[*g].name.empty()) return harmless(model.groups[*g].name) + ", ";
  return "";
}

}  // namespace

std::string spline_text(const SplineReport& report, const Style& style) {
  const std::string path =
      style.bold(report.path == "-" ? "standard input" : unbroken(harmless(report.path)));
  if (!report.file)
    return style.yellow(verdict_word(std::nullopt)) + "  " + path + "  " +
           (report.fault ? harmless(text_of(*report.fault)) : "") + "\n";
  const SplineFile& file = *report.file;
  std::string out = path + "\n";
  out += detail_line("file", std::string(spline_format_name(file.format)) + ", " +
                                 counted(file.bytes, "byte", "bytes"));
  out += detail_line("sha256", file.sha256);
  out += detail_line("splines", counts_text(file.model));
  for (const LeftOut& l : file.left_out)
    out += detail_line("left out", std::to_string(l.count) + " " + harmless(l.what) +
                                       (l.reason.empty() ? "" : ": " + harmless(l.reason)));
  std::vector<ExactInterval> all;
  for (const SplineEntity& e : file.model.entities) unite(all, control_box(e));
  out += detail_line("box", box_text(all));
  std::string names;
  for (const std::string& name : report.lossless) names += (names.empty() ? "" : ", ") + name;
  out += detail_line("lossless as", names.empty() ? "no format" : names);
  const auto& entities = file.model.entities;
  for (std::size_t i = 0; i < std::min(entities.size(), kMostEntities); ++i) {
    const SplineEntity& e = entities[i];
    out += detail_line(std::to_string(i), std::string(spline_kind_name(e)) + ", " +
                                              name_text(file.model, e) + shape_text(e) + ", box " +
                                              box_text(control_box(e)));
  }
  if (entities.size() > kMostEntities)
    out += detail_line(
        "...", std::to_string(entities.size() - kMostEntities) + " more (--json lists them)");
  return out;
}

}  // namespace veritope::report
