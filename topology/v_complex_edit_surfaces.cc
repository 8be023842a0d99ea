// SPDX-License-Identifier: LGPL-3.0-or-later
// V-surfaces are split and merged.
#include <algorithm>
#include <string>
#include <vector>

#include "topology/v_complex_edit.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

using internal::id_text;
using internal::VComplexAccess;

bool is_in_loop(const VComplexTables& t, CurveUseId u, CurveUseId v) {
  const std::vector<CurveUseId> loop = internal::loop_of(t, u);
  return std::find(loop.begin(), loop.end(), v) != loop.end();
}

std::string split_fault(const VComplexTables& t, CurveUseId from, CurveUseId to,
                        std::span<const CurveUseId> moved) {
  if (!t.uses.contains(from) || !t.uses.contains(to) ||
      t.uses[from].half_surface != t.uses[to].half_surface)
    return "uses " + id_text(from) + " and " + id_text(to) + " are not in one half-V-surface";
  const bool is_split = is_in_loop(t, from, to);
  if (!is_split && !moved.empty())
    return "loops are moved, but the V-curve does not split the V-surface";
  std::vector<CurveUseId> seen = internal::loop_of(t, from);
  for (const CurveUseId u : moved) {
    if (!t.uses.contains(u) || t.uses[u].half_surface != t.uses[from].half_surface)
      return "use " + id_text(u) + " is not in the half-V-surface";
    if (std::find(seen.begin(), seen.end(), u) != seen.end())
      return "the loop of use " + id_text(u) + " is split, or moved twice";
    const std::vector<CurveUseId> loop = internal::loop_of(t, u);
    seen.insert(seen.end(), loop.begin(), loop.end());
  }
  return {};
}

// The uses of a V-curve through a half-V-surface: the one there, and the one back.
struct NewUses {
  CurveUseId there, back;
};
NewUses add_uses(VComplexTables& t, HalfVSurfaceId h, VCurveId curve) {
  const NewUses out{t.uses.add({h, {}, {}, curve, true, {}, {}}),
                    t.uses.add({h, {}, {}, curve, false, {}, {}})};
  internal::pair_across(t, out.there, out.back);
  return out;
}

HalfVSurfaceId add_half_beside(VComplexTables& t, HalfVSurfaceId h, VSurfaceId surface) {
  const HalfVSurface half = t.half_surfaces[h];
  const HalfVSurfaceId out = t.half_surfaces.add({half.cell, half.trivariate, surface, {}});
  t.cells[half.cell].half_surfaces.push_back(out);
  return out;
}

void remove_half_beside(VComplexTables& t, HalfVSurfaceId h) {
  auto& list = t.cells[t.half_surfaces[h].cell].half_surfaces;
  list.erase(std::find(list.begin(), list.end(), h));
  t.half_surfaces.remove(h);
}

std::string merge_surfaces_fault(const VComplexTables& t, VCurveId curve) {
  const std::string where = "V-curve " + id_text(curve);
  if (t.curves[curve].fans.size() != 1) return where + " has several fans";
  const VFan fan = internal::fan_of(t, t.curves[curve].fans[0]);
  if (fan.uses.size() != (fan.is_cyclic ? 4u : 2u)) return where + " is not between two V-surfaces";
  for (const CurveUseId u : {fan.uses[0], fan.uses[1]}) {
    // The joined loop, and each of two loops, must have uses left.
    if (t.uses[u].next == t.uses[u].across) return where + " ends in a V-surface";
  }
  const CurveUseId u = fan.uses[0], v = fan.uses[1];
  const HalfVSurfaceId g = t.uses[u].half_surface, h = t.uses[v].half_surface;
  if (g == h)
    return is_in_loop(t, u, v) ? ""
                               : where + " connects two loops of one V-surface around a handle";
  if (t.half_surfaces[g].surface == t.half_surfaces[h].surface)
    return where + " has one V-surface on both sides";
  if (t.uses[u].next == u && t.uses[v].next == v)
    return "nothing would be left of the loops of " + where;
  const auto is_alike = [&](HalfVSurfaceId a, HalfVSurfaceId b) {
    return t.half_surfaces[a].trivariate == t.half_surfaces[b].trivariate;
  };
  if (!is_alike(g, h) || (fan.is_cyclic && !is_alike(t.mate(g), t.mate(h))))
    return where + " is between V-surfaces of different trivariates";
  return {};
}

// Takes the use u, and the one across it, out of their loops. Gives a use of each loop that is left.
std::vector<CurveUseId> take_out(VComplexTables& t, CurveUseId u) {
  const CurveUse here = t.uses[u], there = t.uses[here.across];
  if (here.next == u) {
    internal::join_uses_and_mates(t, there.previous, there.next);
    return {there.next};
  }
  if (there.next == here.across) {
    internal::join_uses_and_mates(t, here.previous, here.next);
    return {here.next};
  }
  internal::join_uses_and_mates(t, here.previous, there.next);
  internal::join_uses_and_mates(t, there.previous, here.next);
  return {here.next, there.next};
}

}  // namespace

Result<SplitSurface> split_surface(VComplex& complex, CurveUseId from, CurveUseId to,
                                   std::span<const CurveUseId> moved) {
  VComplexTables& t = VComplexAccess::tables(complex);
  const std::string fault = split_fault(t, from, to, moved);
  if (!fault.empty()) return bad_argument(fault);
  const bool is_split = is_in_loop(t, from, to);
  const HalfVSurfaceId h = t.uses[from].half_surface, m = t.mate(h);
  const auto mate_of = [&](CurveUseId u) { return t.uses[u].mate; };
  std::vector<CurveUseId> gone{from};  // loops that are not h's any more, or not in this form
  if (!is_split) gone.push_back(to);
  gone.insert(gone.end(), moved.begin(), moved.end());
  for (const CurveUseId u : gone) {
    internal::forget_loop(t, u);
    if (!m.is_none()) internal::forget_loop(t, mate_of(u));
  }

  SplitSurface out;
  const VPointId start = t.start(from), end = t.start(to);
  out.curve = t.curves.add({{start, end}, {}});
  internal::add_curve_at(t, start, out.curve);
  internal::add_curve_at(t, end, out.curve);
  const NewUses in_h = add_uses(t, h, out.curve);
  std::vector<CurveUseId> all{in_h.there, in_h.back};
  if (!m.is_none()) {
    const NewUses in_m = add_uses(t, m, out.curve);
    internal::pair_mates(t, in_h.there, in_m.back);
    internal::pair_mates(t, in_h.back, in_m.there);
    all.insert(all.end(), {in_m.there, in_m.back});
  }
  const CurveUseId before_from = t.uses[from].previous, before_to = t.uses[to].previous;
  internal::join_uses_and_mates(t, before_from, in_h.there);
  internal::join_uses_and_mates(t, in_h.there, to);
  if (from == to) {
    internal::join_uses_and_mates(t, in_h.back, in_h.back);
  } else {
    internal::join_uses_and_mates(t, before_to, in_h.back);
    internal::join_uses_and_mates(t, in_h.back, from);
  }
  t.curves[out.curve].fans = internal::fans_of_uses(t, all);

  internal::take_loop(t, h, in_h.there);
  if (!m.is_none()) internal::take_loop(t, m, mate_of(in_h.there));
  if (!is_split) return out;
  out.surface = t.surfaces.add({});
  const HalfVSurfaceId g = add_half_beside(t, h, out.surface);
  const HalfVSurfaceId n = m.is_none() ? HalfVSurfaceId{} : add_half_beside(t, m, out.surface);
  t.surfaces[out.surface].halves = {g, n};
  gone[0] = in_h.back;
  for (const CurveUseId u : gone) {
    internal::take_loop(t, g, u);
    if (!n.is_none()) internal::take_loop(t, n, mate_of(u));
  }
  return out;
}

Status merge_surfaces(VComplex& complex, VCurveId curve) {
  VComplexTables& t = VComplexAccess::tables(complex);
  if (!t.curves.contains(curve)) return bad_argument("there is no V-curve " + id_text(curve));
  const std::string fault = merge_surfaces_fault(t, curve);
  if (!fault.empty()) return bad_argument(fault);
  const std::vector<CurveUseId> uses = internal::uses_of_curve(t, curve);
  HalfVSurfaceId kept = t.uses[uses[0]].half_surface, other = t.uses[uses[1]].half_surface;
  if (t.half_surfaces[other].surface < t.half_surfaces[kept].surface) std::swap(kept, other);
  const HalfVSurfaceId mate = t.mate(kept), other_mate = t.mate(other);
  const VSurfaceId dropped = t.half_surfaces[other].surface;
  std::vector<CurveUseId> of_h{uses[0]}, of_m;
  if (kept != other) of_h.push_back(uses[1]);
  for (const CurveUseId u : of_h)
    if (!mate.is_none()) of_m.push_back(t.uses[u].mate);
  for (const CurveUseId u : of_h) internal::forget_loop(t, u);
  for (const CurveUseId u : of_m) internal::forget_loop(t, u);
  std::vector<CurveUseId> loops = take_out(t, uses[0]);
  if (kept != other) {
    loops.resize(1);
    const std::vector<CurveUseId> more = t.half_surfaces[other].loops;
    loops.insert(loops.end(), more.begin(), more.end());
  }
  for (const CurveUseId u : loops) {
    internal::take_loop(t, kept, u);
    if (!mate.is_none()) internal::take_loop(t, mate, t.uses[u].mate);
  }
  if (kept != other) {
    remove_half_beside(t, other);
    if (!other_mate.is_none()) remove_half_beside(t, other_mate);
    t.surfaces.remove(dropped);
  }
  for (const CurveUseId u : uses) t.uses.remove(u);
  const auto ends = t.curves[curve].ends;
  internal::drop_curve_at(t, ends[0], curve);
  if (ends[1] != ends[0]) internal::drop_curve_at(t, ends[1], curve);
  t.curves.remove(curve);
  return ok_status();
}

}  // namespace veritope
