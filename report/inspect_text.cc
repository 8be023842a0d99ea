// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "report/decimal_text.h"
#include "report/inspect_report.h"
#include "report/report_text.h"
#include "solids/vmodel/v_parts.h"
#include "topology/v_complex_links.h"

namespace veritope::report {
namespace {

constexpr std::size_t kMostLines = 8;

// The lines of what does not fit one, each below the name of the first, and how many more there are.
class Lines {
 public:
  explicit Lines(std::string name) : name_(std::move(name)) {}
  void add(const std::string& line) {
    if (++count_ > kMostLines) return;
    out_ += detail_line(count_ == 1 ? name_ : "", line);
  }
  std::string text() const {
    if (count_ <= kMostLines) return out_;
    return out_ +
           detail_line("...", std::to_string(count_ - kMostLines) + " more (--json lists them)");
  }

 private:
  std::string name_, out_;
  std::size_t count_ = 0;
};

std::string cells_text(const std::vector<VCellId>& cells) {
  std::string out = cells.size() == 1 ? "cell " : "cells ";
  for (std::size_t i = 0; i < std::min(kMostLines, cells.size()); ++i)
    out += (i == 0 ? "" : ", ") + std::to_string(cells[i].value);
  return out + (cells.size() > kMostLines ? ", ..." : "");
}

std::string counts_text(const VComplexCounts& n) {
  return counted(n.cells, "cell", "cells") + ", " + counted(n.surfaces, "V-surface", "V-surfaces") +
         " (" + std::to_string(n.internal_surfaces) + " internal), " +
         counted(n.curves, "V-curve", "V-curves") + ", " + counted(n.points, "V-point", "V-points");
}

std::string reversed_text(const VModel& model) {
  std::vector<VCellId> cells;
  for (const std::uint32_t c : model.left_handed())
    if (model.is_reversed(c)) cells.push_back(VCellId{c});
  return cells.empty() ? "" : detail_line("reversed", cells_text(cells));
}

// A corner of a cell at the V-point.
std::string place_of(const InspectReport& report, VPointId p) {
  const VCellId cell = report.elements.complex.cells_of_point(p).front();
  const auto& corners = report.elements.points[cell.value];
  const auto corner =
      static_cast<std::size_t>(std::find(corners.begin(), corners.end(), p) - corners.begin());
  std::string out;
  for (const Rational& x : v_corner_point(report.model.cell(cell.value), corner))
    out += (out.empty() ? "(" : ", ") + short_decimal(x);
  return unbroken(out + ")");
}

std::string link_text(const VPointLink& link) {
  if (link.components.size() > 1)
    return "a link of " + std::to_string(link.components.size()) + " components";
  if (link.has_pinched_curve) return "a V-curve of several fans";
  const VPointLinkComponent& part = link.components.front();
  return "a link of genus " + std::to_string(part.genus()) + " with " +
         counted(part.boundary_circles, "boundary circle", "boundary circles");
}

std::string manifold_text(const InspectReport& report) {
  if (report.is_manifold()) return detail_line("manifold", "yes, with boundary");
  const VComplex& complex = report.elements.complex;
  std::string out = detail_line(
      "manifold", "no, at " + counted(report.bad_curves.size(), "V-curve", "V-curves") + " and " +
                      counted(report.bad_points.size(), "V-point", "V-points"));
  Lines curves("");
  for (const VCurveId c : report.bad_curves) {
    const auto& ends = complex.curve(c).ends;
    curves.add("V-curve " + std::to_string(c.value) + " from " + place_of(report, ends[0]) +
               " to " + place_of(report, ends[1]) + ": " +
               std::to_string(complex.curve(c).fans.size()) + " fans, " +
               cells_text(complex.cells_of_curve(c)));
  }
  Lines points("");
  for (const VPointId p : report.bad_points)
    points.add("V-point " + std::to_string(p.value) + " at " + place_of(report, p) + ": " +
               link_text(link_of(complex, p)) + ", " + cells_text(complex.cells_of_point(p)));
  return out + curves.text() + points.text();
}

std::string collapsed_text(const InspectReport& report) {
  Lines out("collapsed");
  for (const auto& c : report.collapsed)
    out.add(c.part + " of cell " + std::to_string(c.cell) + " onto " +
            (c.is_onto_curve ? "V-curve " : "V-point ") + std::to_string(c.onto));
  return out.text();
}

// Equal faces that are no V-surface, since no orientation fits, or there are more than two.
std::string unglued_text(const VModel& model) {
  const auto name = [](VFaceNumber f) {
    return v_face_name(f % 6) + " of cell " + std::to_string(f / 6);
  };
  Lines out("not glued");
  for (const auto& [f, g] : model.copies())
    out.add(name(f) + " and " + name(g) + " are equal, with their cells on the same side");
  for (const auto& equal : model.crowds())
    out.add(std::to_string(equal.size()) + " faces are equal: " + name(equal[0]) + ", " +
            name(equal[1]) + ", ...");
  for (const VForbiddenCollapse& c : model.forbidden())
    out.add("cell " + std::to_string(c.cell) +
            " is collapsed on a part that is no face or edge of it (see certify)");
  return out.text();
}

template <class Id>
std::string common_text(const char* one, const char* many, const std::vector<Id>& ids) {
  std::string out = counted(ids.size(), one, many);
  for (std::size_t i = 0; i < std::min(kMostLines, ids.size()); ++i)
    out += (i == 0 ? ": " : ", ") + std::to_string(ids[i].value);
  return out + (ids.size() > kMostLines ? ", ..." : "");
}

}  // namespace

std::string inspect_text(const InspectReport& report, const Style& style) {
  std::string out = style.bold(unbroken(shown_path(report.path))) + "\n" +
                    detail_line("cells", counts_text(report.elements.complex.counts())) +
                    reversed_text(report.model) + manifold_text(report) +
                    detail_line("components", std::to_string(report.components));
  if (report.betti) {
    const auto& b = *report.betti;
    out += detail_line("Betti", std::to_string(b[0]) + ", " + std::to_string(b[1]) + ", " +
                                    std::to_string(b[2]) + ", " + std::to_string(b[3]));
  }
  return out + collapsed_text(report) + unglued_text(report.model) +
         style.dim("  Whether it bounds a solid: veritope certify --orient auto FILE") + "\n";
}

std::string pair_text(const InspectReport& report, std::array<std::uint32_t, 2> cells,
                      const Style& style) {
  const VCommon common = report.elements.complex.common(VCellId{cells[0]}, VCellId{cells[1]});
  return style.bold(unbroken(shown_path(report.path))) + "\n" +
         detail_line("cells", std::to_string(cells[0]) + " and " + std::to_string(cells[1]) +
                                  (common.is_exactly_one_point() ? " meet at exactly one point"
                                   : common.points.empty()       ? " do not meet"
                                                                 : "")) +
         detail_line("common", common_text("V-surface", "V-surfaces", common.surfaces)) +
         detail_line("", common_text("V-curve", "V-curves", common.curves)) +
         detail_line("", common_text("V-point", "V-points", common.points));
}

}  // namespace veritope::report
