// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/inspect_report.h"

#include <utility>

#include "robust/base/disjoint_sets.h"
#include "solids/vmodel/v_complex_of.h"
#include "solids/vmodel/v_parts.h"
#include "topology/v_complex_homology.h"
#include "topology/v_complex_links.h"

namespace veritope::report {
namespace {

std::uint64_t components_of(const VComplex& complex) {
  const VComplexTables& t = complex.tables();
  DisjointSets<> sets(t.cells.end_id());
  std::vector<std::uint32_t> first(t.points.end_id(), VCellId::kNone);
  for (const CurveUseId u : t.uses) {
    const VCellId cell = t.half_surfaces[t.uses[u].half_surface].cell;
    std::uint32_t& known = first[t.start(u).value];
    if (known == VCellId::kNone) known = cell.value;
    sets.join(known, cell.value);
  }
  std::uint64_t out = 0;
  for (const VCellId c : t.cells) out += sets.find(c.value) == c.value ? 1 : 0;
  return out;
}

// The edge of a face along one of its axes, at the beginning of the other one.
std::size_t edge_of_face(std::size_t face, std::size_t along) {
  const auto others = v_face_axes(along);
  return 4 * along + (others[0] == face / 2 ? face % 2 : 2 * (face % 2));
}

void list_collapsed_faces(InspectReport& report, std::uint32_t cell) {
  for (std::size_t k = 0; k < 6; ++k) {
    const VCollapse collapse = report.model.face(cell, k).collapse;
    if (collapse == VCollapse::kNone) continue;
    const auto axes = v_face_axes(k / 2);
    InspectReport::Collapsed out{cell, v_face_name(k), collapse != VCollapse::kToPoint, 0};
    const std::size_t corner = k % 2 << k / 2;
    const std::size_t edge = edge_of_face(k, axes[collapse == VCollapse::kAlongFirst ? 1 : 0]);
    out.onto = out.is_onto_curve ? report.elements.curves[cell][edge].value
                                 : report.elements.points[cell][corner].value;
    report.collapsed.push_back(std::move(out));
  }
}

void list_collapsed_edges(InspectReport& report, std::uint32_t cell) {
  for (std::size_t e = 0; e < 12; ++e) {
    if (!report.model.is_edge_collapsed(cell, e)) continue;
    const auto others = v_face_axes(e / 4);
    const std::size_t corner = (e & 1) << others[0] | (e >> 1 & 1) << others[1];
    report.collapsed.push_back(
        {cell, v_edge_name(e), false, report.elements.points[cell][corner].value});
  }
}

}  // namespace

Result<InspectReport> inspect_v_model(std::string path, VModel model) {
  Result<HexahedralVComplex> elements = v_complex_of(model);
  if (!elements) return elements.error();
  InspectReport out{std::move(path), std::move(model), std::move(*elements), {}, {}, {}, 0, {}};
  const VComplex& complex = out.elements.complex;
  out.bad_curves = nonmanifold_curves(complex);
  out.bad_points = nonmanifold_points(complex);
  if (auto betti = betti_numbers(complex)) out.betti = *betti;
  out.components = components_of(complex);
  for (std::uint32_t c = 0; c < out.model.num_cells(); ++c) {
    list_collapsed_faces(out, c);
    list_collapsed_edges(out, c);
  }
  return out;
}

}  // namespace veritope::report
