// SPDX-License-Identifier: LGPL-3.0-or-later
// Cells are added, removed, split and merged.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "topology/v_complex_edit.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

using internal::id_text;
using internal::VComplexAccess;

template <class Id>
void shift_id(std::uint32_t by, Id& id) {
  if (!id.is_none()) id.value += by;
}

// Adds the tables of another complex, whose ids are 0, 1, ..., with new ids.
void append_tables(VComplexTables& t, const VComplexTables& from) {
  const std::uint32_t cells = t.cells.end_id(), surfaces = t.surfaces.end_id(),
                      halves = t.half_surfaces.end_id(), uses = t.uses.end_id(),
                      curves = t.curves.end_id(), points = t.points.end_id();
  for (const VCellId id : from.cells) {
    VCell cell = from.cells[id];
    for (HalfVSurfaceId& h : cell.half_surfaces) shift_id(halves, h);
    t.cells.add(std::move(cell));
  }
  for (const VSurfaceId id : from.surfaces) {
    VSurface surface = from.surfaces[id];
    for (HalfVSurfaceId& h : surface.halves) shift_id(halves, h);
    t.surfaces.add(surface);
  }
  for (const HalfVSurfaceId id : from.half_surfaces) {
    HalfVSurface half = from.half_surfaces[id];
    shift_id(cells, half.cell);
    shift_id(surfaces, half.surface);
    for (CurveUseId& u : half.loops) shift_id(uses, u);
    t.half_surfaces.add(std::move(half));
  }
  for (const CurveUseId id : from.uses) {
    CurveUse use = from.uses[id];
    shift_id(halves, use.half_surface);
    shift_id(curves, use.curve);
    for (CurveUseId* u : {&use.next, &use.previous, &use.across, &use.mate}) shift_id(uses, *u);
    t.uses.add(use);
  }
  for (const VCurveId id : from.curves) {
    VCurve curve = from.curves[id];
    for (VPointId& p : curve.ends) shift_id(points, p);
    for (CurveUseId& u : curve.fans) shift_id(uses, u);
    t.curves.add(std::move(curve));
  }
  for (const VPointId id : from.points) {
    VPoint point = from.points[id];
    for (VCurveId& c : point.curves) shift_id(curves, c);
    t.points.add(std::move(point));
  }
}

// The half-V-surfaces that are connected with those of `seeds` without passing a use of `border`.
std::set<HalfVSurfaceId> connected_halves(const VComplexTables& t,
                                          std::vector<HalfVSurfaceId> seeds,
                                          const std::set<CurveUseId>& border) {
  std::set<HalfVSurfaceId> out;
  while (!seeds.empty()) {
    const HalfVSurfaceId h = seeds.back();
    seeds.pop_back();
    if (!out.insert(h).second) continue;
    for (const CurveUseId u : internal::uses_of_half(t, h))
      if (!border.contains(u)) seeds.push_back(t.uses[t.uses[u].across].half_surface);
  }
  return out;
}

// Nothing is wrong if the result is empty.
std::string cycle_fault(const VComplexTables& t, std::span<const CurveUseId> cycle) {
  if (cycle.empty()) return "a cycle without V-curves";
  std::set<CurveUseId> used, corners;
  for (const CurveUseId u : cycle) {
    if (!t.uses.contains(u)) return "there is no use " + id_text(u);
    if (!used.insert(u).second || !used.insert(t.uses[u].across).second)
      return "the cycle passes use " + id_text(u) + " twice";
  }
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const CurveUseId last = t.uses[cycle[i]].next, next = cycle[(i + 1) % cycle.size()];
    bool is_there = false;
    CurveUseId at = last;
    do {
      if (!corners.insert(at).second) return "the cycle passes a corner of the V-cell twice";
      is_there = is_there || at == next;
      at = t.uses[t.uses[at].across].next;
    } while (at != last);
    if (!is_there)
      return "use " + id_text(next) + " does not begin at the corner where the one before ends";
  }
  return {};
}

void move_halves(VComplexTables& t, const std::set<HalfVSurfaceId>& halves, VCellId from,
                 VCellId to) {
  std::vector<HalfVSurfaceId>& list = t.cells[from].half_surfaces;
  list.erase(std::remove_if(list.begin(), list.end(),
                            [&](HalfVSurfaceId h) { return halves.contains(h); }),
             list.end());
  for (const HalfVSurfaceId h : halves) {
    t.half_surfaces[h].cell = to;
    t.cells[to].half_surfaces.push_back(h);
  }
}

// The two halves of a new disk between the left and the right of the cycle.
VSurfaceId add_disk(VComplexTables& t, std::span<const CurveUseId> cycle, VCellId left,
                    VCellId right, std::uint32_t trivariate) {
  const HalfVSurfaceId f = t.half_surfaces.add({left, trivariate, {}, {}});
  const HalfVSurfaceId g = t.half_surfaces.add({right, trivariate, {}, {}});
  const VSurfaceId s = t.surfaces.add({{f, g}});
  t.half_surfaces[f].surface = t.half_surfaces[g].surface = s;
  t.cells[left].half_surfaces.push_back(f);
  t.cells[right].half_surfaces.push_back(g);
  std::vector<CurveUseId> in_f, in_g;
  for (const CurveUseId u : cycle) {
    const CurveUse use = t.uses[u];
    const CurveUseId x = t.uses.add({f, {}, {}, use.curve, !use.is_forward, {}, {}});
    const CurveUseId y = t.uses.add({g, {}, {}, use.curve, use.is_forward, {}, {}});
    internal::pair_across(t, y, use.across);
    internal::pair_across(t, x, u);
    internal::pair_mates(t, x, y);
    in_f.push_back(x);
    in_g.push_back(y);
  }
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const std::size_t j = (i + 1) % cycle.size();
    internal::join_uses(t, in_f[j], in_f[i]);
    internal::join_uses(t, in_g[i], in_g[j]);
  }
  t.half_surfaces[f].loops.push_back(in_f[0]);
  t.half_surfaces[g].loops.push_back(in_g[0]);
  return s;
}

// Gives the fans of the curves of these uses, of which some are removed now.
void list_fans_again(VComplexTables& t,
                     const std::vector<std::pair<VCurveId, std::vector<CurveUseId>>>& before) {
  for (const auto& [curve, uses] : before) {
    std::vector<CurveUseId> left;
    for (const CurveUseId u : uses)
      if (t.uses.contains(u)) left.push_back(u);
    t.curves[curve].fans = internal::fans_of_uses(t, std::move(left));
  }
}

std::vector<std::pair<VCurveId, std::vector<CurveUseId>>> uses_by_curve(
    const VComplexTables& t, std::vector<VCurveId> curves) {
  internal::sort_unique(curves);
  std::vector<std::pair<VCurveId, std::vector<CurveUseId>>> out;
  for (const VCurveId c : curves) out.emplace_back(c, internal::uses_of_curve(t, c));
  return out;
}

void remove_half(VComplexTables& t, HalfVSurfaceId h) {
  for (const CurveUseId u : internal::uses_of_half(t, h)) t.uses.remove(u);
  t.half_surfaces.remove(h);
}

// A V-surface can be removed if its closure is embedded in the boundaries of its cells: then what is on both sides is
// glued along a surface. Nothing is wrong if the result is empty.
std::string merge_cells_fault(const VComplexTables& t, VSurfaceId surface) {
  const auto halves = t.surfaces[surface].halves;
  if (t.half_surfaces[halves[0]].cell == t.half_surfaces[halves[1]].cell) {
    // The inverse of a cut: a disk becomes a handle. Everything else would be no part of space.
    if (t.half_surfaces[halves[0]].loops.size() != 1 ||
        !connected_halves(t, {halves[0]}, {}).contains(halves[1]))
      return "V-surface " + id_text(surface) +
             " is in one V-cell, and no disk on one surface of its boundary";
  }
  std::set<CurveUseId> corners;
  for (const HalfVSurfaceId h : halves) {
    for (const CurveUseId u : internal::uses_of_half(t, h)) {
      if (t.half_surfaces[t.uses[t.uses[u].across].half_surface].surface == surface)
        return "V-curve " + id_text(t.uses[u].curve) + " has V-surface " + id_text(surface) +
               " on two sides in a V-cell";
      CurveUseId at = u;
      do {
        if (!corners.insert(at).second)
          return "V-surface " + id_text(surface) + " meets itself at V-point " +
                 id_text(t.start(u)) + " in a corner of a V-cell";
        at = t.uses[t.uses[at].across].next;
      } while (at != u);
    }
  }
  return {};
}

}  // namespace

Result<VCellId> add_cell(VComplex& complex, const VComplexData& one_cell) {
  if (one_cell.cells.size() != 1)
    return bad_argument("a list of " + std::to_string(one_cell.cells.size()) +
                        " V-cells instead of one");
  const Result<VComplex> made = make_v_complex(one_cell);
  if (!made) return made.error();
  VComplexTables& t = VComplexAccess::tables(complex);
  const VCellId out{t.cells.end_id()};
  append_tables(t, made.value().tables());
  return out;
}

Status remove_cell(VComplex& complex, VCellId cell) {
  VComplexTables& t = VComplexAccess::tables(complex);
  if (!t.cells.contains(cell)) return bad_argument("there is no V-cell " + id_text(cell));
  const std::vector<HalfVSurfaceId> halves = t.cells[cell].half_surfaces;
  for (const HalfVSurfaceId h : halves) {
    if (t.mate(h).is_none()) continue;
    const Status status = unglue(complex, t.half_surfaces[h].surface);
    VT_CHECK(status.has_value(), "a V-surface of a cell cannot be unglued");
  }
  const auto before = uses_by_curve(t, complex.curves_of_cell(cell));
  for (const HalfVSurfaceId h : halves) {
    t.surfaces.remove(t.half_surfaces[h].surface);
    remove_half(t, h);
  }
  t.cells.remove(cell);
  list_fans_again(t, before);
  for (const auto& [curve, uses] : before) {
    if (!t.curves[curve].fans.empty()) continue;
    const auto ends = t.curves[curve].ends;
    internal::drop_curve_at(t, ends[0], curve);
    if (ends[1] != ends[0]) internal::drop_curve_at(t, ends[1], curve);
    t.curves.remove(curve);
  }
  return ok_status();
}

Result<SplitCell> split_cell(VComplex& complex, std::span<const CurveUseId> cycle,
                             std::uint32_t trivariate, std::span<const HalfVSurfaceId> moved) {
  VComplexTables& t = VComplexAccess::tables(complex);
  const std::string fault = cycle_fault(t, cycle);
  if (!fault.empty()) return bad_argument(fault);
  const VCellId cell = t.half_surfaces[t.uses[cycle[0]].half_surface].cell;
  const auto& trivariates = t.cells[cell].trivariates;
  if (std::find(trivariates.begin(), trivariates.end(), trivariate) == trivariates.end())
    return bad_argument("trivariate " + std::to_string(trivariate) + " is not one of V-cell " +
                        id_text(cell));
  std::set<CurveUseId> border;
  std::vector<HalfVSurfaceId> on_left, on_right(moved.begin(), moved.end());
  for (const HalfVSurfaceId h : moved)
    if (!t.half_surfaces.contains(h) || t.half_surfaces[h].cell != cell)
      return bad_argument("V-cell " + id_text(cell) + " has no half-V-surface " + id_text(h));
  for (const CurveUseId u : cycle) {
    border.insert({u, t.uses[u].across});
    on_left.push_back(t.uses[u].half_surface);
    on_right.push_back(t.uses[t.uses[u].across].half_surface);
  }
  const auto left = connected_halves(t, on_left, border),
             right = connected_halves(t, on_right, border);
  const bool is_connected =
      std::any_of(left.begin(), left.end(), [&](HalfVSurfaceId h) { return right.contains(h); });
  if (is_connected && !moved.empty())
    return bad_argument("the cycle does not split V-cell " + id_text(cell) +
                        " into what stays and what is moved");
  SplitCell out;
  if (!is_connected) {
    out.cell = t.cells.add({t.cells[cell].trivariates, {}});
    move_halves(t, right, cell, out.cell);
  }
  out.surface = add_disk(t, cycle, cell, is_connected ? cell : out.cell, trivariate);
  return out;
}

Status merge_cells(VComplex& complex, VSurfaceId surface) {
  VComplexTables& t = VComplexAccess::tables(complex);
  if (!t.surfaces.contains(surface) || !t.surfaces[surface].is_internal())
    return bad_argument("V-surface " + id_text(surface) + " is not there, or not inside");
  const auto halves = t.surfaces[surface].halves;
  const VCellId kept = t.half_surfaces[halves[0]].cell, other = t.half_surfaces[halves[1]].cell;
  const auto sorted = [&](VCellId c) {
    std::vector<std::uint32_t> out = t.cells[c].trivariates;
    internal::sort_unique(out);
    return out;
  };
  if (sorted(kept) != sorted(other))
    return bad_argument("V-cells " + id_text(kept) + " and " + id_text(other) +
                        " have other trivariates");
  const std::string fault = merge_cells_fault(t, surface);
  if (!fault.empty()) return bad_argument(fault);
  const std::vector<CurveUseId> uses = internal::uses_of_half(t, halves[0]);
  std::vector<VCurveId> curves;
  for (const CurveUseId x : uses) curves.push_back(t.uses[x].curve);
  const auto before = uses_by_curve(t, curves);
  for (const CurveUseId x : uses)
    internal::pair_across(t, t.uses[x].across, t.uses[t.uses[x].mate].across);
  for (const HalfVSurfaceId h : halves) {
    auto& list = t.cells[t.half_surfaces[h].cell].half_surfaces;
    list.erase(std::find(list.begin(), list.end(), h));
    remove_half(t, h);
  }
  t.surfaces.remove(surface);
  if (kept != other) {
    const auto& list = t.cells[other].half_surfaces;
    move_halves(t, {list.begin(), list.end()}, other, kept);
    t.cells.remove(other);
  }
  list_fans_again(t, before);
  return ok_status();
}

}  // namespace veritope
