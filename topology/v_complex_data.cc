// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/v_complex_data.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

using internal::id_text;

std::string half_text(std::size_t cell, std::size_t half) {
  return "V-cell " + std::to_string(cell) + ", half-V-surface " + std::to_string(half);
}

class VComplexMaker {
 public:
  explicit VComplexMaker(const VComplexData& data) : data_(data) {}

  Result<VComplex> make() {
    for (const auto step :
         {&VComplexMaker::add_points_and_curves, &VComplexMaker::add_cells,
          &VComplexMaker::pair_given, &VComplexMaker::pair_others, &VComplexMaker::glue_all}) {
      const Status status = (this->*step)();
      if (!status) return status.error();
    }
    list_all_fans();
    for (const VCurveId c : t_.curves)
      if (t_.curves[c].fans.empty()) return bad_argument("no loop uses V-curve " + id_text(c));
    for (const VPointId p : t_.points)
      if (t_.points[p].curves.empty())
        return bad_argument("no V-curve begins or ends at V-point " + id_text(p));
    return VComplex::from_tables(std::move(t_));
  }

 private:
  Status add_points_and_curves() {
    for (std::uint32_t p = 0; p < data_.num_points; ++p) t_.points.add({});
    for (std::size_t c = 0; c < data_.curves.size(); ++c) {
      const auto& ends = data_.curves[c];
      if (std::max(ends[0], ends[1]) >= data_.num_points)
        return bad_argument("V-curve " + std::to_string(c) + " ends at V-point " +
                            std::to_string(std::max(ends[0], ends[1])) + ", which is not there");
      const VCurveId id = t_.curves.add({{VPointId{ends[0]}, VPointId{ends[1]}}, {}});
      for (const VPointId p : t_.curves[id].ends) internal::add_curve_at(t_, p, id);
    }
    return ok_status();
  }

  Status add_cells() {
    for (std::size_t c = 0; c < data_.cells.size(); ++c) {
      const VCellData& cell = data_.cells[c];
      if (cell.half_surfaces.empty() || cell.trivariates.empty())
        return bad_argument("V-cell " + std::to_string(c) +
                            " has no half-V-surface, or no trivariate");
      const VCellId id = t_.cells.add({cell.trivariates, {}});
      halves_.emplace_back();
      for (std::size_t h = 0; h < cell.half_surfaces.size(); ++h) {
        const Status status = add_half(id, cell.half_surfaces[h], half_text(c, h));
        if (!status) return status;
      }
    }
    return ok_status();
  }

  Status add_half(VCellId cell, const HalfVSurfaceData& data, const std::string& where) {
    const auto& trivariates = t_.cells[cell].trivariates;
    if (std::find(trivariates.begin(), trivariates.end(), data.trivariate) == trivariates.end())
      return bad_argument(where + ": trivariate " + std::to_string(data.trivariate) +
                          " is not one of the V-cell's");
    if (data.loops.empty()) return bad_argument(where + " has no loop");
    const HalfVSurfaceId h = t_.half_surfaces.add({cell, data.trivariate, {}, {}});
    t_.half_surfaces[h].surface = t_.surfaces.add({{h, HalfVSurfaceId{}}});
    t_.cells[cell].half_surfaces.push_back(h);
    halves_.back().push_back(h);
    for (const auto& loop : data.loops) {
      const Status status = add_loop(h, loop, where);
      if (!status) return status;
    }
    return ok_status();
  }

  Status add_loop(HalfVSurfaceId h, const std::vector<CurveUseData>& loop,
                  const std::string& where) {
    if (loop.empty()) return bad_argument(where + " has a loop without V-curves");
    const std::uint32_t first = t_.uses.end_id();
    const auto n = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      if (loop[i].curve >= data_.curves.size())
        return bad_argument(where + ": there is no V-curve " + std::to_string(loop[i].curve));
      t_.uses.add({h,
                   CurveUseId{first + (i + 1) % n},
                   CurveUseId{first + (i + n - 1) % n},
                   VCurveId{loop[i].curve},
                   loop[i].is_forward,
                   {},
                   {}});
    }
    t_.half_surfaces[h].loops.push_back(CurveUseId{first});
    for (std::uint32_t i = 0; i < n; ++i) {
      const CurveUseId u{first + i};
      if (t_.end(u) != t_.start(t_.uses[u].next))
        return bad_argument(where + ": the loop is not closed; it ends V-curve " +
                            id_text(t_.uses[u].curve) + " at V-point " + id_text(t_.end(u)) +
                            ", and goes on from V-point " + id_text(t_.start(t_.uses[u].next)));
    }
    return ok_status();
  }

  // Returns no id if there is no such place.
  HalfVSurfaceId half_at(const HalfVSurfacePlace& place) const {
    if (place.cell >= halves_.size() || place.half_surface >= halves_[place.cell].size()) return {};
    return halves_[place.cell][place.half_surface];
  }
  CurveUseId use_at(const CurveUsePlace& place) const {
    const HalfVSurfaceId h = half_at({place.cell, place.half_surface});
    if (h.is_none() || place.loop >= t_.half_surfaces[h].loops.size()) return {};
    const auto loop = internal::loop_of(t_, t_.half_surfaces[h].loops[place.loop]);
    return place.use < loop.size() ? loop[place.use] : CurveUseId{};
  }
  VCellId cell_of(CurveUseId u) const { return t_.half_surfaces[t_.uses[u].half_surface].cell; }
  bool is_opposite_of(CurveUseId u, CurveUseId v) const {
    return t_.uses[u].curve == t_.uses[v].curve && t_.uses[u].is_forward != t_.uses[v].is_forward;
  }

  Status pair_given() {
    for (const auto& pair : data_.across) {
      const CurveUseId u = use_at(pair[0]), v = use_at(pair[1]);
      if (u.is_none() || v.is_none())
        return bad_argument("across: there is no such use of a V-curve");
      if (!is_opposite_of(u, v) || cell_of(u) != cell_of(v))
        return bad_argument("across: uses " + id_text(u) + " and " + id_text(v) +
                            " are not in one V-cell on one V-curve in opposite directions");
      if (!t_.uses[u].across.is_none() || !t_.uses[v].across.is_none())
        return bad_argument("across: use " + id_text(u) + " or " + id_text(v) + " is there twice");
      internal::pair_across(t_, u, v);
    }
    return ok_status();
  }

  // What is left must be one use in each direction for each curve of a cell.
  Status pair_others() {
    std::map<std::pair<VCellId, VCurveId>, std::vector<CurveUseId>> left;
    for (const CurveUseId u : t_.uses)
      if (t_.uses[u].across.is_none()) left[{cell_of(u), t_.uses[u].curve}].push_back(u);
    for (const auto& [key, uses] : left) {
      const std::string where = "V-cell " + id_text(key.first) + ", V-curve " + id_text(key.second);
      if (uses.size() > 2)
        return bad_argument(
            where + ": it is used more than twice, and it is not said which uses are across");
      if (uses.size() == 1 || t_.uses[uses[0]].is_forward == t_.uses[uses[1]].is_forward)
        return bad_argument(where +
                            ": it is not used once in each direction; the boundary is not closed");
      internal::pair_across(t_, uses[0], uses[1]);
    }
    return ok_status();
  }

  Status glue_all() {
    for (const auto& pair : data_.mates) {
      const CurveUseId u = use_at(pair[0]), v = use_at(pair[1]);
      if (u.is_none() || v.is_none())
        return bad_argument("mates: there is no such use of a V-curve");
      hints_[u] = v;
      hints_[v] = u;
    }
    for (const auto& pair : data_.glued) {
      const Status status = glue_pair(half_at(pair[0]), half_at(pair[1]));
      if (!status) return status;
    }
    for (const auto& [u, v] : hints_)
      if (t_.uses[u].mate != v)
        return bad_argument("mates: use " + id_text(u) + " is not glued in this way");
    return ok_status();
  }

  Status glue_pair(HalfVSurfaceId a, HalfVSurfaceId b) {
    if (a.is_none() || b.is_none()) return bad_argument("glued: there is no such half-V-surface");
    const std::string where = "half-V-surfaces " + id_text(a) + " and " + id_text(b);
    if (a == b) return bad_argument(where + " are one");
    if (!t_.mate(a).is_none() || !t_.mate(b).is_none())
      return bad_argument(where + ": one is glued twice");
    if (t_.half_surfaces[a].loops.size() != t_.half_surfaces[b].loops.size())
      return bad_argument(where + " have not equally many loops");
    for (const CurveUseId first : t_.half_surfaces[a].loops) {
      const Status status = glue_loop(first, b, where);
      if (!status) return status;
    }
    const VSurfaceId dropped = std::max(t_.half_surfaces[a].surface, t_.half_surfaces[b].surface);
    const VSurfaceId kept = std::min(t_.half_surfaces[a].surface, t_.half_surfaces[b].surface);
    t_.surfaces[kept].halves[1] = t_.surfaces[dropped].halves[0];
    t_.half_surfaces[t_.surfaces[dropped].halves[0]].surface = kept;
    t_.surfaces.remove(dropped);
    return ok_status();
  }

  Status glue_loop(CurveUseId first, HalfVSurfaceId b, const std::string& where) {
    CurveUseId start = first;
    for (const CurveUseId u : internal::loop_of(t_, first))
      if (hints_.contains(u)) start = u;
    std::vector<CurveUseId> candidates;
    if (hints_.contains(start)) {
      candidates.push_back(hints_[start]);
    } else {
      for (const CurveUseId v : internal::uses_of_half(t_, b))
        if (t_.uses[v].mate.is_none() && is_opposite_of(start, v)) candidates.push_back(v);
    }
    if (candidates.size() != 1)
      return bad_argument(
          where + ": use " + id_text(start) + " has " +
          (candidates.empty() ? "no use that could be its mate" : "several possible mates"));
    CurveUseId u = start, v = candidates[0];
    do {
      if (t_.uses[v].half_surface != b || !is_opposite_of(u, v) || !t_.uses[v].mate.is_none())
        return bad_argument(where + ": their loops do not fit at the uses " + id_text(u) + " and " +
                            id_text(v));
      internal::pair_mates(t_, u, v);
      u = t_.uses[u].next;
      v = t_.uses[v].previous;
    } while (u != start);
    if (v != candidates[0]) return bad_argument(where + ": their loops are not equally long");
    return ok_status();
  }

  void list_all_fans() {
    std::vector<std::vector<CurveUseId>> uses(data_.curves.size());
    for (const CurveUseId u : t_.uses) uses[t_.uses[u].curve.value].push_back(u);
    for (const VCurveId c : t_.curves)
      t_.curves[c].fans = internal::fans_of_uses(t_, std::move(uses[c.value]));
  }

  const VComplexData& data_;
  VComplexTables t_;
  std::vector<std::vector<HalfVSurfaceId>> halves_;  // of each cell
  std::map<CurveUseId, CurveUseId> hints_;
};

}  // namespace

Result<VComplex> make_v_complex(const VComplexData& data) {
  Result<VComplex> made = VComplexMaker(data).make();
  if (!made) return made.error();
  return compacted(made.value());  // without the V-surfaces of second halves
}

}  // namespace veritope
