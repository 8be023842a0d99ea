// SPDX-License-Identifier: LGPL-3.0-or-later
// Intersections for people.
#include "report/decimal_text.h"
#include "report/intersection_report.h"
#include "report/text_style.h"

namespace veritope::report {
namespace {

std::string place_text(const Box3& box) {
  return "(" + range_text(box[0]) + ", " + range_text(box[1]) + ", " + range_text(box[2]) + ")";
}
std::string name_text(const NamedSurface& s) {
  return std::to_string(s.entity) + (s.face ? " face " + std::to_string(*s.face) : "");
}

std::string lines_of(const PairIntersection& p) {
  std::string out = "  surfaces " + name_text(p.first) + " and " + name_text(p.second) + "\n";
  for (const IntersectionBranch& b : p.found.branches)
    out += std::string("    ") +
           (b.is_partial ? "piece of a branch" : (b.is_closed ? "loop" : "arc")) + "  length " +
           range_text(b.length) + "  gap at most " + short_decimal(b.gap, 3) + "  " +
           std::to_string(b.num_boxes) + " boxes\n";
  for (const IntersectionContact& c : p.found.overlaps)
    out += "    overlap  in " + place_text(c.space) + "\n";
  for (const IntersectionContact& c : p.found.tangencies)
    out += std::string("    tangency, ") + shape_name(c.shape) + "  separation " +
           range_text(c.separation) + "  in " + place_text(c.space) + "\n";
  for (const IntersectionContact& c : p.found.unresolved)
    out += "    undecided: " + c.reason + "  in " + place_text(c.space) + "\n";
  return out;
}

}  // namespace

std::string intersection_text(const IntersectionReport& report) {
  std::size_t loops = 0, arcs = 0, others = 0;
  for (const PairIntersection& p : report.pairs) {
    for (const IntersectionBranch& b : p.found.branches) ++(b.is_closed ? loops : arcs);
    others += p.found.overlaps.size() + p.found.tangencies.size();
  }
  std::string out = std::string(report.is_complete() ? "COMPLETE" : "UNDECIDED") + "  " +
                    unbroken(harmless(report.paths[0])) + " and " +
                    unbroken(harmless(report.paths[1])) + "  " + std::to_string(loops) +
                    " loops, " + std::to_string(arcs) + " arcs, " + std::to_string(others) +
                    " tangencies and overlaps\n";
  if (report.ignores_trimming)
    out += "  Trimming curves were not looked at: these are the whole surfaces.\n";
  if (report.ignored_triangles != 0)
    out += "  Not looked at: " +
           counted(report.ignored_triangles, "Bezier triangle", "Bezier triangles") + ".\n";
  for (const PairIntersection& p : report.pairs) out += lines_of(p);
  return out;
}

}  // namespace veritope::report
