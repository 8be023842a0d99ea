// SPDX-License-Identifier: LGPL-3.0-or-later
// Half-V-surfaces are glued and unglued: V-curves and V-points are the classes that gluing makes.
#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/disjoint_sets.h"
#include "topology/v_complex_edit.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

using internal::id_text;
using internal::VComplexAccess;

template <class Id>
std::size_t index_in(const std::vector<Id>& ascending, Id id) {
  const auto at = std::lower_bound(ascending.begin(), ascending.end(), id);
  VT_CHECK(at != ascending.end() && *at == id, "an id that is not in the list");
  return static_cast<std::size_t>(at - ascending.begin());
}

// Classes of V-curves, each with its direction in comparison with the least one of its class.
class DirectedClasses {
 public:
  explicit DirectedClasses(std::vector<VCurveId> curves) : curves_(std::move(curves)) {
    internal::sort_unique(curves_);
    for (std::size_t i = 0; i < curves_.size(); ++i) of_.emplace_back(i, false);
  }
  const std::vector<VCurveId>& curves() const { return curves_; }

  struct Place {
    VCurveId least;
    bool is_reversed;
  };
  Place find(VCurveId c) const {
    const auto [root, flip] = of_[index_in(curves_, c)];
    return {curves_[root], flip};
  }
  /// False if a curve would become its own reverse.
  bool join(VCurveId c, VCurveId d, bool is_reversed) {
    const auto a = of_[index_in(curves_, c)], b = of_[index_in(curves_, d)];
    const bool flip = (a.second != b.second) != is_reversed;
    if (a.first == b.first) return !flip;
    const std::size_t kept = std::min(a.first, b.first), gone = std::max(a.first, b.first);
    for (auto& place : of_)
      if (place.first == gone) place = {kept, place.second != flip};
    return true;
  }

 private:
  std::vector<VCurveId> curves_;
  std::vector<std::pair<std::size_t, bool>> of_;  // the least one of the class; is it reversed?
};

// What a gluing needs, or what is wrong with it.
struct GluePlan {
  std::string fault;
  HalfVSurfaceId first, second;
  std::vector<UsePair> pairs;  // of all uses
};

std::string add_loop_pairs(const VComplexTables& t, const UsePair& start,
                           std::vector<UsePair>& pairs) {
  const std::string where = "the loops of uses " + id_text(start[0]) + " and " + id_text(start[1]);
  for (const UsePair& pair : pairs)
    if (pair[0] == start[0] || pair[1] == start[1]) return where + " are there twice";
  UsePair at = start;
  do {
    pairs.push_back(at);
    at = {t.uses[at[0]].next, t.uses[at[1]].previous};
  } while (at[0] != start[0] && at[1] != start[1]);
  return at == start ? "" : where + " are not equally long";
}

GluePlan plan_gluing(const VComplexTables& t, std::span<const UsePair> starts) {
  GluePlan out;
  const auto failed = [&](std::string fault) {
    out.fault = std::move(fault);
    return out;
  };
  if (starts.empty()) return failed("no uses to glue");
  for (const UsePair& pair : starts)
    if (!t.uses.contains(pair[0]) || !t.uses.contains(pair[1]))
      return failed("there is no use " + id_text(pair[t.uses.contains(pair[0]) ? 1 : 0]));
  out.first = t.uses[starts[0][0]].half_surface;
  out.second = t.uses[starts[0][1]].half_surface;
  const std::string where = "half-V-surfaces " + id_text(out.first) + " and " + id_text(out.second);
  if (out.first == out.second) return failed(where + " are one");
  if (!t.mate(out.first).is_none() || !t.mate(out.second).is_none())
    return failed("one of " + where + " is glued already");
  for (const HalfVSurfaceId h : {out.first, out.second})
    if (t.half_surfaces[h].loops.size() != starts.size())
      return failed(where + " do not both have " + std::to_string(starts.size()) + " loops");
  for (const UsePair& pair : starts) {
    if (t.uses[pair[0]].half_surface != out.first || t.uses[pair[1]].half_surface != out.second)
      return failed("a pair of uses is not of " + where);
    const std::string fault = add_loop_pairs(t, pair, out.pairs);
    if (!fault.empty()) return failed(fault);
  }
  return out;
}

std::vector<VCurveId> curves_of_pairs(const VComplexTables& t, const std::vector<UsePair>& pairs) {
  std::vector<VCurveId> out;
  for (const UsePair& pair : pairs)
    for (const CurveUseId u : pair) out.push_back(t.uses[u].curve);
  internal::sort_unique(out);
  return out;
}

std::vector<VPointId> points_of_pairs(const VComplexTables& t, const std::vector<UsePair>& pairs) {
  std::vector<VPointId> out;
  for (const UsePair& pair : pairs)
    for (const CurveUseId u : pair) out.push_back(t.start(u));
  internal::sort_unique(out);
  return out;
}

void join_points(VComplexTables& t, const std::vector<UsePair>& pairs,
                 const DirectedClasses& classes) {
  const std::vector<VPointId> points = points_of_pairs(t, pairs);
  DisjointSets<std::size_t> sets(points.size());
  for (const UsePair& pair : pairs) {
    sets.join(index_in(points, t.start(pair[0])), index_in(points, t.end(pair[1])));
    sets.join(index_in(points, t.end(pair[0])), index_in(points, t.start(pair[1])));
  }
  std::vector<std::vector<VCurveId>> lists(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t least = sets.find(i);
    for (const VCurveId c : t.points[points[i]].curves) {
      for (VPointId& p : t.curves[c].ends)
        if (p == points[i]) p = points[least];
      const bool is_glued = std::binary_search(classes.curves().begin(), classes.curves().end(), c);
      lists[least].push_back(is_glued ? classes.find(c).least : c);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (sets.find(i) != i) {
      t.points.remove(points[i]);
      continue;
    }
    internal::sort_unique(lists[i]);
    t.points[points[i]].curves = std::move(lists[i]);
  }
}

// REQUIRES that the uses are mates already.
void join_curves(VComplexTables& t, const DirectedClasses& classes,
                 const std::map<VCurveId, std::vector<CurveUseId>>& uses_before) {
  std::map<VCurveId, std::vector<CurveUseId>> uses;
  for (const auto& [c, list] : uses_before) {
    const auto [least, is_reversed] = classes.find(c);
    uses[least].insert(uses[least].end(), list.begin(), list.end());
    if (least == c) continue;
    for (const CurveUseId u : list) {
      t.uses[u].curve = least;
      t.uses[u].is_forward = t.uses[u].is_forward != is_reversed;
    }
    t.curves.remove(c);
  }
  for (auto& [c, list] : uses) t.curves[c].fans = internal::fans_of_uses(t, std::move(list));
}

// Gives for each of the uses, which begin at one V-point and ascend, the first one of those that V-cells, V-surfaces
// and V-curves connect with it there.
std::vector<std::size_t> classes_at_point(const VComplexTables& t,
                                          const std::vector<CurveUseId>& uses) {
  DisjointSets<std::size_t> sets(uses.size());
  std::map<std::pair<VCurveId, unsigned>, std::size_t> at_end;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const CurveUse& use = t.uses[uses[i]];
    sets.join(i, index_in(uses, t.uses[use.across].next));
    if (!use.mate.is_none()) sets.join(i, index_in(uses, t.uses[use.mate].next));
    sets.join(i, at_end.try_emplace({use.curve, t.start_end(uses[i])}, i).first->second);
  }
  std::vector<std::size_t> out(uses.size());
  for (std::size_t i = 0; i < uses.size(); ++i) out[i] = sets.find(i);
  return out;
}

struct FormerFan {
  VCurveId curve;
  std::vector<CurveUseId> uses;
};

// The parts of a fan beside the one with the least use become curves of their own.
void part_fan(VComplexTables& t, const FormerFan& fan) {
  std::vector<CurveUseId> parts = internal::fans_of_uses(t, fan.uses);
  const auto least_use = [&](CurveUseId first) {
    const VFan part = internal::fan_of(t, first);
    return *std::min_element(part.uses.begin(), part.uses.end());
  };
  std::sort(parts.begin(), parts.end(),
            [&](CurveUseId a, CurveUseId b) { return least_use(a) < least_use(b); });
  t.curves[fan.curve].fans.push_back(parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto ends = t.curves[fan.curve].ends;
    const VCurveId d = t.curves.add({ends, {parts[i]}});
    const VFan part = internal::fan_of(t, parts[i]);
    for (const CurveUseId u : part.uses) t.uses[u].curve = d;
    for (const VPointId p : ends) internal::add_curve_at(t, p, d);
  }
}

struct FormerPoint {
  VPointId point;
  std::vector<CurveUseId> uses;      // that begin there, ascending
  std::vector<std::size_t> classes;  // classes_at_point() before
};

void part_point(VComplexTables& t, const FormerPoint& former) {
  const std::vector<std::size_t> now = classes_at_point(t, former.uses);
  std::map<std::size_t, VPointId> point_of;  // of each class
  std::vector<VPointId> at(former.uses.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    // The class with the least use of the class before is met first.
    if (now[i] == i) point_of[i] = former.classes[i] == i ? former.point : t.points.add({});
    at[i] = point_of[now[i]];
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    const CurveUse& use = t.uses[former.uses[i]];
    t.curves[use.curve].ends[t.start_end(former.uses[i])] = at[i];
    internal::add_curve_at(t, at[i], use.curve);
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    const VCurveId c = t.uses[former.uses[i]].curve;
    const auto& ends = t.curves[c].ends;
    if (ends[0] != former.point && ends[1] != former.point)
      internal::drop_curve_at(t, former.point, c);
  }
}

}  // namespace

Status glue(VComplex& complex, std::span<const UsePair> pairs) {
  VComplexTables& t = VComplexAccess::tables(complex);
  const GluePlan plan = plan_gluing(t, pairs);
  if (!plan.fault.empty()) return bad_argument(plan.fault);
  DirectedClasses classes(curves_of_pairs(t, plan.pairs));
  for (const auto& [u, v] : plan.pairs)
    if (!classes.join(t.uses[u].curve, t.uses[v].curve,
                      t.uses[u].is_forward == t.uses[v].is_forward))
      return bad_argument("V-curve " + id_text(t.uses[u].curve) +
                          " would be glued to its own reverse");
  std::map<VCurveId, std::vector<CurveUseId>> uses_before;
  for (const VCurveId c : classes.curves()) uses_before[c] = internal::uses_of_curve(t, c);
  join_points(t, plan.pairs, classes);
  for (const auto& [u, v] : plan.pairs) internal::pair_mates(t, u, v);
  join_curves(t, classes, uses_before);
  const VSurfaceId kept = t.half_surfaces[plan.first].surface;
  t.surfaces.remove(t.half_surfaces[plan.second].surface);
  t.half_surfaces[plan.second].surface = kept;
  t.surfaces[kept].halves = {plan.first, plan.second};
  return ok_status();
}

Status unglue(VComplex& complex, VSurfaceId surface) {
  VComplexTables& t = VComplexAccess::tables(complex);
  if (!t.surfaces.contains(surface) || !t.surfaces[surface].is_internal())
    return bad_argument("V-surface " + id_text(surface) + " is not there, or not inside");
  const auto halves = t.surfaces[surface].halves;
  std::vector<UsePair> pairs;
  for (const CurveUseId u : internal::uses_of_half(t, halves[0]))
    pairs.push_back({u, t.uses[u].mate});
  std::vector<FormerFan> fans;
  for (const VCurveId c : curves_of_pairs(t, pairs)) {
    for (const CurveUseId first : t.curves[c].fans)
      fans.push_back({c, internal::fan_of(t, first).uses});
  }
  std::vector<FormerPoint> points;
  for (const VPointId p : points_of_pairs(t, pairs)) {
    std::vector<CurveUseId> uses = complex.uses_from(p);
    std::sort(uses.begin(), uses.end());
    std::vector<std::size_t> before = classes_at_point(t, uses);
    points.push_back({p, std::move(uses), std::move(before)});
  }
  for (const UsePair& pair : pairs)
    for (const CurveUseId u : pair) t.uses[u].mate = {};
  for (const FormerFan& fan : fans) t.curves[fan.curve].fans.clear();
  for (const FormerFan& fan : fans) part_fan(t, fan);
  for (const FormerPoint& point : points) part_point(t, point);
  t.surfaces[surface].halves[1] = {};
  t.half_surfaces[halves[1]].surface = t.surfaces.add({{halves[1], HalfVSurfaceId{}}});
  return ok_status();
}

}  // namespace veritope
