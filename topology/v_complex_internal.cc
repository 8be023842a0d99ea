// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/v_complex_internal.h"

namespace veritope::internal {

std::vector<CurveUseId> loop_of(const VComplexTables& t, CurveUseId u) {
  std::vector<CurveUseId> out;
  CurveUseId at = u;
  do {
    out.push_back(at);
    at = t.uses[at].next;
  } while (at != u);
  return out;
}

std::vector<CurveUseId> uses_of_half(const VComplexTables& t, HalfVSurfaceId h) {
  std::vector<CurveUseId> out;
  for (const CurveUseId first : t.half_surfaces[h].loops)
    for (const CurveUseId u : loop_of(t, first)) out.push_back(u);
  return out;
}

VFan fan_of(const VComplexTables& t, CurveUseId first) {
  VFan out;
  CurveUseId at = first;
  do {
    const CurveUseId along = t.uses[at].across;
    out.uses.push_back(at);
    out.uses.push_back(along);
    at = t.uses[along].mate;
  } while (!at.is_none() && at != first);
  out.is_cyclic = !at.is_none();
  return out;
}

std::vector<CurveUseId> uses_of_curve(const VComplexTables& t, VCurveId c) {
  std::vector<CurveUseId> out;
  for (const CurveUseId first : t.curves[c].fans) {
    const VFan fan = fan_of(t, first);
    out.insert(out.end(), fan.uses.begin(), fan.uses.end());
  }
  return out;
}

std::vector<CurveUseId> uses_from(const VComplexTables& t, VPointId p) {
  std::vector<CurveUseId> out;
  for (const VCurveId c : t.points[p].curves)
    for (const CurveUseId u : uses_of_curve(t, c))
      if (t.start(u) == p) out.push_back(u);
  return out;
}

std::vector<CurveUseId> fans_of_uses(const VComplexTables& t, std::vector<CurveUseId> uses) {
  std::sort(uses.begin(), uses.end());
  std::vector<bool> seen(uses.size());
  std::vector<CurveUseId> out;
  const auto take = [&](CurveUseId first) {
    const VFan fan = fan_of(t, first);
    for (const CurveUseId u : fan.uses) {
      const auto at = std::lower_bound(uses.begin(), uses.end(), u);
      VT_CHECK(at != uses.end() && *at == u, "a fan leaves the uses of its curve");
      seen[static_cast<std::size_t>(at - uses.begin())] = true;
    }
    out.push_back(first);
  };
  const auto is_against = [&](std::size_t i) { return !t.uses[uses[i]].is_forward; };
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (is_against(i) && t.uses[uses[i]].mate.is_none()) take(uses[i]);
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (is_against(i) && !seen[i]) take(uses[i]);
  std::sort(out.begin(), out.end());
  return out;
}

void join_uses(VComplexTables& t, CurveUseId u, CurveUseId v) {
  t.uses[u].next = v;
  t.uses[v].previous = u;
}

void join_uses_and_mates(VComplexTables& t, CurveUseId u, CurveUseId v) {
  join_uses(t, u, v);
  if (!t.uses[u].mate.is_none()) join_uses(t, t.uses[v].mate, t.uses[u].mate);
}

void pair_across(VComplexTables& t, CurveUseId u, CurveUseId v) {
  t.uses[u].across = v;
  t.uses[v].across = u;
}

void pair_mates(VComplexTables& t, CurveUseId u, CurveUseId v) {
  t.uses[u].mate = v;
  t.uses[v].mate = u;
}

void forget_loop(VComplexTables& t, CurveUseId u) {
  std::vector<CurveUseId>& loops = t.half_surfaces[t.uses[u].half_surface].loops;
  for (const CurveUseId v : loop_of(t, u)) {
    const auto at = std::find(loops.begin(), loops.end(), v);
    if (at == loops.end()) continue;
    loops.erase(at);
    return;
  }
  VT_CHECK(false, "a loop that its half-V-surface does not list");
}

void take_loop(VComplexTables& t, HalfVSurfaceId h, CurveUseId u) {
  for (const CurveUseId v : loop_of(t, u)) t.uses[v].half_surface = h;
  t.half_surfaces[h].loops.push_back(u);
}

void add_curve_at(VComplexTables& t, VPointId p, VCurveId c) {
  std::vector<VCurveId>& curves = t.points[p].curves;
  if (std::find(curves.begin(), curves.end(), c) == curves.end()) curves.push_back(c);
}

void drop_curve_at(VComplexTables& t, VPointId p, VCurveId c) {
  std::vector<VCurveId>& curves = t.points[p].curves;
  curves.erase(std::remove(curves.begin(), curves.end(), c), curves.end());
  if (curves.empty()) t.points.remove(p);
}

}  // namespace veritope::internal
