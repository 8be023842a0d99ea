// SPDX-License-Identifier: LGPL-3.0-or-later
// The nine invariants of topology/v_complex.h, one function each. Each function may assume those before it.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "topology/v_complex.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

using internal::id_text;
using Text = std::optional<std::string>;  // what is wrong

Text bad_references_of_parts(const VComplexTables& t) {
  for (const VCellId c : t.cells)
    for (const HalfVSurfaceId h : t.cells[c].half_surfaces)
      if (!t.half_surfaces.contains(h)) return "V-cell " + id_text(c) + " lists no half-V-surface";
  for (const VSurfaceId s : t.surfaces) {
    const auto& halves = t.surfaces[s].halves;
    if (!t.half_surfaces.contains(halves[0]) ||
        (!halves[1].is_none() && !t.half_surfaces.contains(halves[1])))
      return "V-surface " + id_text(s) + " has a half that does not exist";
  }
  for (const HalfVSurfaceId h : t.half_surfaces) {
    const HalfVSurface& half = t.half_surfaces[h];
    bool is_good = t.cells.contains(half.cell) && t.surfaces.contains(half.surface);
    for (const CurveUseId u : half.loops) is_good = is_good && t.uses.contains(u);
    if (!is_good) return "half-V-surface " + id_text(h) + " refers to what does not exist";
  }
  return {};
}

Text bad_references(const VComplexTables& t) {
  if (auto text = bad_references_of_parts(t)) return text;
  for (const CurveUseId u : t.uses) {
    const CurveUse& use = t.uses[u];
    const bool is_good = t.half_surfaces.contains(use.half_surface) && t.uses.contains(use.next) &&
                         t.uses.contains(use.previous) && t.curves.contains(use.curve) &&
                         t.uses.contains(use.across) &&
                         (use.mate.is_none() || t.uses.contains(use.mate));
    if (!is_good) return "use " + id_text(u) + " of a V-curve refers to what does not exist";
  }
  for (const VCurveId c : t.curves) {
    const VCurve& curve = t.curves[c];
    bool is_good = t.points.contains(curve.ends[0]) && t.points.contains(curve.ends[1]);
    for (const CurveUseId u : curve.fans) is_good = is_good && t.uses.contains(u);
    if (!is_good) return "V-curve " + id_text(c) + " refers to what does not exist";
  }
  for (const VPointId p : t.points)
    for (const VCurveId c : t.points[p].curves)
      if (!t.curves.contains(c)) return "V-point " + id_text(p) + " lists no V-curve";
  return {};
}

Text bad_cells(const VComplexTables& t) {
  std::size_t listed = 0;
  std::vector<bool> seen(t.half_surfaces.end_id());
  for (const VCellId c : t.cells) {
    const VCell& cell = t.cells[c];
    if (cell.half_surfaces.empty() || cell.trivariates.empty())
      return "V-cell " + id_text(c) + " has no half-V-surface, or no trivariate";
    for (const HalfVSurfaceId h : cell.half_surfaces) {
      const std::uint32_t number = t.half_surfaces[h].trivariate;
      if (t.half_surfaces[h].cell != c || seen[h.value])
        return "V-cell " + id_text(c) + " lists half-V-surface " + id_text(h) +
               ", which is not its own";
      if (std::find(cell.trivariates.begin(), cell.trivariates.end(), number) ==
          cell.trivariates.end())
        return "half-V-surface " + id_text(h) + " has a trivariate that its V-cell does not have";
      seen[h.value] = true;
      ++listed;
    }
  }
  if (listed != t.half_surfaces.size()) return "a half-V-surface is listed by no V-cell";
  return {};
}

Text bad_surfaces(const VComplexTables& t) {
  std::size_t listed = 0;
  for (const VSurfaceId s : t.surfaces) {
    const auto& halves = t.surfaces[s].halves;
    bool is_good = halves[0] != halves[1];
    for (const HalfVSurfaceId h : halves) {
      if (h.is_none()) continue;
      is_good = is_good && t.half_surfaces[h].surface == s;
      ++listed;
    }
    if (!is_good) return "V-surface " + id_text(s) + " and its halves do not refer to each other";
  }
  if (listed != t.half_surfaces.size()) return "a half-V-surface is a half of no V-surface";
  return {};
}

Text bad_loops(const VComplexTables& t) {
  for (const CurveUseId u : t.uses) {
    const CurveUse& use = t.uses[u];
    if (t.uses[use.next].previous != u || t.uses[use.previous].next != u ||
        t.uses[use.next].half_surface != use.half_surface)
      return "use " + id_text(u) + " and its neighbours in the loop do not refer to each other";
  }
  std::size_t listed = 0;
  std::vector<bool> seen(t.uses.end_id());
  for (const HalfVSurfaceId h : t.half_surfaces) {
    if (t.half_surfaces[h].loops.empty()) return "half-V-surface " + id_text(h) + " has no loop";
    for (const CurveUseId first : t.half_surfaces[h].loops) {
      if (seen[first.value] || t.uses[first].half_surface != h)
        return "half-V-surface " + id_text(h) + " lists a loop twice, or one that is not its own";
      for (const CurveUseId u : internal::loop_of(t, first)) {
        seen[u.value] = true;
        ++listed;
      }
    }
  }
  if (listed != t.uses.size()) return "a loop is listed by no half-V-surface";
  return {};
}

Text bad_ends(const VComplexTables& t) {
  for (const CurveUseId u : t.uses)
    if (t.end(u) != t.start(t.uses[u].next))
      return "use " + id_text(u) + " does not end where the next one begins";
  return {};
}

// Whether v is another use of u's curve, in the opposite direction.
bool is_opposite(const VComplexTables& t, CurveUseId u, CurveUseId v) {
  return u != v && t.uses[u].curve == t.uses[v].curve &&
         t.uses[u].is_forward != t.uses[v].is_forward;
}

Text bad_across(const VComplexTables& t) {
  for (const CurveUseId u : t.uses) {
    const CurveUseId v = t.uses[u].across;
    const auto cell = [&](CurveUseId w) { return t.half_surfaces[t.uses[w].half_surface].cell; };
    if (t.uses[v].across != u || !is_opposite(t, u, v) || cell(u) != cell(v))
      return "use " + id_text(u) + " has no use across the V-curve in its V-cell";
  }
  return {};
}

Text bad_mates(const VComplexTables& t) {
  for (const CurveUseId u : t.uses) {
    const CurveUse& use = t.uses[u];
    const HalfVSurfaceId mate = t.mate(use.half_surface);
    if (mate.is_none() != use.mate.is_none())
      return "use " + id_text(u) + " has a mate without its half-V-surface, or has none with it";
    if (mate.is_none()) continue;
    const CurveUse& other = t.uses[use.mate];
    if (other.mate != u || other.half_surface != mate || !is_opposite(t, u, use.mate))
      return "use " + id_text(u) + " and its mate do not fit together";
    if (t.uses[use.next].mate != other.previous)
      return "the loops of use " + id_text(u) + " and of its mate do not fit together";
  }
  return {};
}

Text bad_fans(const VComplexTables& t) {
  std::size_t listed = 0;
  std::vector<bool> seen(t.uses.end_id());
  for (const VCurveId c : t.curves) {
    if (t.curves[c].fans.empty()) return "V-curve " + id_text(c) + " has no fan";
    for (const CurveUseId first : t.curves[c].fans) {
      if (seen[first.value] || t.uses[first].is_forward || t.uses[first].curve != c)
        return "V-curve " + id_text(c) +
               " lists a fan twice, or by a use along it or of another one";
      const VFan fan = internal::fan_of(t, first);
      if (!fan.is_cyclic && !t.uses[first].mate.is_none())
        return "V-curve " + id_text(c) + " lists an open fan by a use in the middle";
      for (const CurveUseId u : fan.uses) seen[u.value] = true;
      listed += fan.uses.size();
    }
  }
  if (listed != t.uses.size()) return "a fan is listed by no V-curve";
  return {};
}

Text bad_points(const VComplexTables& t) {
  std::size_t listed = 0, ends = 0;
  for (const VPointId p : t.points) {
    std::vector<VCurveId> curves = t.points[p].curves;
    bool is_good = !curves.empty();
    for (const VCurveId c : curves)
      is_good = is_good && (t.curves[c].ends[0] == p || t.curves[c].ends[1] == p);
    internal::sort_unique(curves);
    if (!is_good || curves.size() != t.points[p].curves.size())
      return "V-point " + id_text(p) +
             " lists no V-curve, one twice, or one that does not end there";
    listed += curves.size();
  }
  for (const VCurveId c : t.curves) ends += t.curves[c].ends[0] == t.curves[c].ends[1] ? 1 : 2;
  if (listed != ends) return "an end of a V-curve is not listed by its V-point";
  return {};
}

}  // namespace

std::optional<VViolation> validate(const VComplexTables& tables) {
  using Test = Text (*)(const VComplexTables&);
  constexpr std::array<Test, 9> kTests{bad_references, bad_cells, bad_surfaces, bad_loops, bad_ends,
                                       bad_across,     bad_mates, bad_fans,     bad_points};
  for (std::size_t i = 0; i < kTests.size(); ++i)
    if (const Text text = kTests[i](tables))
      return VViolation{static_cast<VInvariant>(i + 1), *text};
  return {};
}

}  // namespace veritope
