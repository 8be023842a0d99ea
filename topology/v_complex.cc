// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/v_complex.h"

#include <algorithm>
#include <iterator>

#include "topology/v_complex_internal.h"

namespace veritope {

using internal::sort_unique;

Result<VComplex> VComplex::from_tables(VComplexTables tables) {
  if (const auto violation = validate(tables))
    return bad_argument("these are no tables of a V-complex: " + violation->message);
  VComplex out;
  out.tables_ = std::move(tables);
  return out;
}

VComplexCounts VComplex::counts() const {
  const std::uint64_t surfaces = tables_.surfaces.size(), halves = tables_.half_surfaces.size();
  return {tables_.cells.size(), surfaces, halves - surfaces, halves, tables_.curves.size(),
          tables_.points.size()};
}

std::vector<CurveUseId> VComplex::loop(CurveUseId u) const { return internal::loop_of(tables_, u); }

std::vector<std::vector<CurveUseId>> VComplex::loops(HalfVSurfaceId h) const {
  std::vector<std::vector<CurveUseId>> out;
  for (const CurveUseId u : half_surface(h).loops) out.push_back(loop(u));
  return out;
}

std::vector<VFan> VComplex::fans(VCurveId c) const {
  std::vector<VFan> out;
  for (const CurveUseId first : curve(c).fans) out.push_back(internal::fan_of(tables_, first));
  return out;
}

std::vector<CurveUseId> VComplex::uses_from(VPointId p) const {
  return internal::uses_from(tables_, p);
}

std::vector<HalfVSurfaceId> VComplex::half_surfaces_of_curve(VCurveId c) const {
  std::vector<HalfVSurfaceId> out;
  for (const CurveUseId u : internal::uses_of_curve(tables_, c)) out.push_back(use(u).half_surface);
  return out;
}

std::vector<VSurfaceId> VComplex::surfaces_of_curve(VCurveId c) const {
  std::vector<VSurfaceId> out;
  for (const CurveUseId u : internal::uses_of_curve(tables_, c))
    out.push_back(half_surface(use(u).half_surface).surface);
  sort_unique(out);
  return out;
}

std::vector<VCellId> VComplex::cells_of_curve(VCurveId c) const {
  std::vector<VCellId> out;
  for (const CurveUseId u : internal::uses_of_curve(tables_, c))
    out.push_back(half_surface(use(u).half_surface).cell);
  sort_unique(out);
  return out;
}

std::vector<VSurfaceId> VComplex::surfaces_of_point(VPointId p) const {
  std::vector<VSurfaceId> out;
  for (const CurveUseId u : uses_from(p)) out.push_back(half_surface(use(u).half_surface).surface);
  sort_unique(out);
  return out;
}

std::vector<VCellId> VComplex::cells_of_point(VPointId p) const {
  std::vector<VCellId> out;
  for (const CurveUseId u : uses_from(p)) out.push_back(half_surface(use(u).half_surface).cell);
  sort_unique(out);
  return out;
}

std::vector<VCellId> VComplex::neighbours(VCellId c) const {
  std::vector<VCellId> out;
  for (const HalfVSurfaceId h : cell(c).half_surfaces) {
    const HalfVSurfaceId m = mate(h);
    if (!m.is_none() && half_surface(m).cell != c) out.push_back(half_surface(m).cell);
  }
  sort_unique(out);
  return out;
}

std::vector<VSurfaceId> VComplex::surfaces_of_cell(VCellId c) const {
  std::vector<VSurfaceId> out;
  for (const HalfVSurfaceId h : cell(c).half_surfaces) out.push_back(half_surface(h).surface);
  sort_unique(out);
  return out;
}

std::vector<VCurveId> VComplex::curves_of_cell(VCellId c) const {
  std::vector<VCurveId> out;
  for (const HalfVSurfaceId h : cell(c).half_surfaces)
    for (const CurveUseId u : internal::uses_of_half(tables_, h)) out.push_back(use(u).curve);
  sort_unique(out);
  return out;
}

std::vector<VPointId> VComplex::points_of_cell(VCellId c) const {
  std::vector<VPointId> out;
  for (const HalfVSurfaceId h : cell(c).half_surfaces)
    for (const CurveUseId u : internal::uses_of_half(tables_, h)) out.push_back(start(u));
  sort_unique(out);
  return out;
}

VCommon VComplex::common(VCellId a, VCellId b) const {
  const auto both = [](const auto& x, const auto& y, auto& out) {
    std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(out));
  };
  VCommon out;
  both(surfaces_of_cell(a), surfaces_of_cell(b), out.surfaces);
  both(curves_of_cell(a), curves_of_cell(b), out.curves);
  both(points_of_cell(a), points_of_cell(b), out.points);
  return out;
}

}  // namespace veritope
