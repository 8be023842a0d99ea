// SPDX-License-Identifier: LGPL-3.0-or-later
// V-curves and V-points are split, merged and identified.
#include <algorithm>
#include <string>
#include <vector>

#include "topology/v_complex_edit.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

using internal::id_text;
using internal::VComplexAccess;

// The curve that goes on where another one ends: uses of the second one by those of the first.
void insert_second_uses(VComplexTables& t, const std::vector<CurveUseId>& firsts, VCurveId second) {
  std::vector<CurveUseId> added;
  for (const CurveUseId u : firsts) {
    const CurveUse use = t.uses[u];
    const CurveUseId v = t.uses.add({use.half_surface, {}, {}, second, use.is_forward, {}, {}});
    if (use.is_forward) {
      internal::join_uses(t, v, use.next);
      internal::join_uses(t, u, v);
    } else {
      internal::join_uses(t, use.previous, v);
      internal::join_uses(t, v, u);
    }
    added.push_back(v);
  }
  const auto second_of = [&](CurveUseId u) {
    return t.uses[u].is_forward ? t.uses[u].next : t.uses[u].previous;
  };
  for (const CurveUseId u : firsts) {
    t.uses[second_of(u)].across = second_of(t.uses[u].across);
    if (!t.uses[u].mate.is_none()) t.uses[second_of(u)].mate = second_of(t.uses[u].mate);
  }
  t.curves[second].fans = internal::fans_of_uses(t, std::move(added));
}

// Nothing is wrong if the result is empty.
std::string merge_fault(const VComplexTables& t, VPointId p) {
  const std::vector<VCurveId>& curves = t.points[p].curves;
  const std::string where = "V-point " + id_text(p);
  if (curves.size() != 2) return where + " does not have two V-curves";
  for (const VCurveId c : curves)
    if (t.curves[c].ends[0] == t.curves[c].ends[1]) return "V-curve " + id_text(c) + " is closed";
  for (const CurveUseId v : internal::uses_from(t, p)) {
    const CurveUseId u = t.uses[v].previous;
    if (t.uses[u].curve == t.uses[v].curve) return "a loop turns back at " + where;
    if (t.uses[t.uses[t.uses[v].across].next].across != u)
      return where + " has more than two V-curve uses around a corner of a V-cell";
  }
  return {};
}

void drop_use(VComplexTables& t, CurveUseId v) {
  const CurveUse use = t.uses[v];
  for (CurveUseId& first : t.half_surfaces[use.half_surface].loops)
    if (first == v) first = use.next;
  internal::join_uses(t, use.previous, use.next);
  t.uses.remove(v);
}

}  // namespace

Result<SplitCurve> split_curve(VComplex& complex, VCurveId curve) {
  VComplexTables& t = VComplexAccess::tables(complex);
  if (!t.curves.contains(curve)) return bad_argument("there is no V-curve " + id_text(curve));
  const std::vector<CurveUseId> uses = internal::uses_of_curve(t, curve);
  const auto ends = t.curves[curve].ends;
  const VPointId p = t.points.add({});
  const VCurveId second = t.curves.add({{p, ends[1]}, {}});
  t.curves[curve].ends[1] = p;
  t.points[p].curves = {curve, second};
  internal::add_curve_at(t, ends[1], second);
  if (ends[0] != ends[1]) internal::drop_curve_at(t, ends[1], curve);
  insert_second_uses(t, uses, second);
  return SplitCurve{p, second};
}

Status merge_curves(VComplex& complex, VPointId point) {
  VComplexTables& t = VComplexAccess::tables(complex);
  if (!t.points.contains(point)) return bad_argument("there is no V-point " + id_text(point));
  const std::string fault = merge_fault(t, point);
  if (!fault.empty()) return bad_argument(fault);
  const VCurveId kept = std::min(t.points[point].curves[0], t.points[point].curves[1]);
  const VCurveId other = std::max(t.points[point].curves[0], t.points[point].curves[1]);
  const std::vector<CurveUseId> dropped = internal::uses_of_curve(t, other);
  const auto other_ends = t.curves[other].ends;
  const VPointId far = other_ends[other_ends[0] == point ? 1 : 0];
  for (const CurveUseId v : dropped) drop_use(t, v);
  t.curves[kept].ends[t.curves[kept].ends[0] == point ? 0 : 1] = far;
  internal::add_curve_at(t, far, kept);
  internal::drop_curve_at(t, far, other);
  t.curves.remove(other);
  t.points.remove(point);
  return ok_status();
}

Status identify_points(VComplex& complex, VPointId kept, VPointId other) {
  VComplexTables& t = VComplexAccess::tables(complex);
  if (!t.points.contains(kept) || !t.points.contains(other) || kept == other)
    return bad_argument("V-points " + id_text(kept) + " and " + id_text(other) +
                        " are not two V-points");
  const std::vector<VCurveId> curves = t.points[other].curves;
  for (const VCurveId c : curves) {
    for (VPointId& p : t.curves[c].ends)
      if (p == other) p = kept;
    internal::add_curve_at(t, kept, c);
  }
  t.points.remove(other);
  return ok_status();
}

Status identify_curves(VComplex& complex, VCurveId kept, VCurveId other, bool is_reversed) {
  VComplexTables& t = VComplexAccess::tables(complex);
  if (!t.curves.contains(kept) || !t.curves.contains(other) || kept == other)
    return bad_argument("V-curves " + id_text(kept) + " and " + id_text(other) +
                        " are not two V-curves");
  auto ends = t.curves[other].ends;
  if (is_reversed) std::swap(ends[0], ends[1]);
  if (ends != t.curves[kept].ends)
    return bad_argument("V-curves " + id_text(kept) + " and " + id_text(other) +
                        " have other V-points");
  std::vector<CurveUseId> uses = internal::uses_of_curve(t, other);
  for (const CurveUseId u : uses) {
    t.uses[u].curve = kept;
    t.uses[u].is_forward = t.uses[u].is_forward != is_reversed;
  }
  const std::vector<CurveUseId> fans = internal::fans_of_uses(t, std::move(uses));
  t.curves[kept].fans.insert(t.curves[kept].fans.end(), fans.begin(), fans.end());
  internal::drop_curve_at(t, ends[0], other);
  if (ends[1] != ends[0]) internal::drop_curve_at(t, ends[1], other);
  t.curves.remove(other);
  return ok_status();
}

}  // namespace veritope
