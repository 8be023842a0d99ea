// SPDX-License-Identifier: LGPL-3.0-or-later
// Projections for people.
#include "report/decimal_text.h"
#include "report/projection_report.h"
#include "report/text_style.h"

namespace veritope::report {
namespace {

template <std::size_t N>
std::string line_of(const CriticalPoint<N>& p) {
  std::string out = "    " + std::string(critical_kind_name(p.kind)) + "  distance " +
                    range_text(p.distance) + "  at (";
  for (std::size_t a = 0; a < N; ++a)
    out += (a > 0 ? ", " : "") + std::string(p.is_held[a] ? "= " : "") +
           short_decimal(p.parameters.middle()[a], 9);
  out += ")";
  if (p.place == RootPlace::kAtBoundary) out += "  on the border or just outside";
  return out + "\n";
}

template <std::size_t N>
std::string text_of(const Projection<N>& p) {
  std::string out;
  for (const auto& c : p.points) out += line_of(c);
  for (const auto& r : p.open)
    out += "    undecided (" + std::string(open_reason_name(r.reason)) + ")  distance " +
           range_text(r.distance) + "  in " + to_string(r.parameters) + "\n";
  return out;
}

}  // namespace

std::string projection_text(const ProjectionReport& report) {
  const auto nearest = report.nearest();
  std::string out = std::string(report.is_complete() ? "COMPLETE" : "UNDECIDED") + "  " +
                    unbroken(harmless(report.path)) + "  distance " +
                    range_text(report.distance()) + (nearest ? "" : "  nearest point not decided") +
                    "\n";
  if (report.skipped_triangles != 0)
    out += "  Not looked at: " +
           counted(report.skipped_triangles, "Bezier triangle", "Bezier triangles") + ".\n";
  for (std::size_t t = 0; t < report.targets.size(); ++t) {
    const ProjectionTarget& target = report.targets[t];
    out += "  " + target.kind + " " + std::to_string(target.entity) +
           (target.face ? ", face " + std::to_string(*target.face) : "") +
           (nearest && nearest->first == t ? ": nearest is point " + std::to_string(nearest->second)
                                           : "") +
           "\n";
    out += std::visit([](const auto& p) { return text_of(p); }, target.projection);
  }
  return out;
}

}  // namespace veritope::report
