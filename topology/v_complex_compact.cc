// SPDX-License-Identifier: LGPL-3.0-or-later
#include <vector>

#include "topology/v_complex.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

// The new id of each old one.
template <class Id, class T>
std::vector<Id> renumber_ids(const IdTable<Id, T>& table) {
  std::vector<Id> out(table.end_id());
  std::uint32_t next = 0;
  for (const Id id : table) out[id.value] = Id{next++};
  return out;
}

template <class Id>
void replace_id(const std::vector<Id>& now, Id& id) {
  if (!id.is_none()) id = now[id.value];
}
template <class Id>
void replace_ids(const std::vector<Id>& now, std::vector<Id>& ids) {
  for (Id& id : ids) replace_id(now, id);
}

}  // namespace

VComplex compacted(const VComplex& complex) {
  const VComplexTables& from = complex.tables();
  const auto cells = renumber_ids(from.cells);
  const auto surfaces = renumber_ids(from.surfaces);
  const auto halves = renumber_ids(from.half_surfaces);
  const auto uses = renumber_ids(from.uses);
  const auto curves = renumber_ids(from.curves);
  const auto points = renumber_ids(from.points);
  VComplex out;
  VComplexTables& to = internal::VComplexAccess::tables(out);
  for (const VCellId id : from.cells) {
    VCell cell = from.cells[id];
    replace_ids(halves, cell.half_surfaces);
    to.cells.add(std::move(cell));
  }
  for (const VSurfaceId id : from.surfaces) {
    VSurface surface = from.surfaces[id];
    for (HalfVSurfaceId& h : surface.halves) replace_id(halves, h);
    to.surfaces.add(surface);
  }
  for (const HalfVSurfaceId id : from.half_surfaces) {
    HalfVSurface half = from.half_surfaces[id];
    replace_id(cells, half.cell);
    replace_id(surfaces, half.surface);
    replace_ids(uses, half.loops);
    to.half_surfaces.add(std::move(half));
  }
  for (const CurveUseId id : from.uses) {
    CurveUse use = from.uses[id];
    replace_id(halves, use.half_surface);
    replace_id(curves, use.curve);
    for (CurveUseId* u : {&use.next, &use.previous, &use.across, &use.mate}) replace_id(uses, *u);
    to.uses.add(use);
  }
  for (const VCurveId id : from.curves) {
    VCurve curve = from.curves[id];
    for (VPointId& p : curve.ends) replace_id(points, p);
    replace_ids(uses, curve.fans);
    to.curves.add(std::move(curve));
  }
  for (const VPointId id : from.points) {
    VPoint point = from.points[id];
    replace_ids(curves, point.curves);
    to.points.add(std::move(point));
  }
  return out;
}

}  // namespace veritope
