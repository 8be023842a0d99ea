// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_complex_of.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "solids/vmodel/v_edge_internal.h"
#include "solids/vmodel/v_parts.h"
#include "topology/v_complex_edit.h"

namespace veritope {
namespace {

using internal::VEdge;

HexahedralFace::Kind kind_of(const VFaceRole& role) {
  if (role.is_glued()) return HexahedralFace::Kind::kGlued;
  switch (role.collapse) {
    case VCollapse::kToPoint: return HexahedralFace::Kind::kToPoint;
    case VCollapse::kAlongFirst: return HexahedralFace::Kind::kAlongFirst;
    case VCollapse::kAlongSecond: return HexahedralFace::Kind::kAlongSecond;
    case VCollapse::kNone: break;
  }
  return HexahedralFace::Kind::kBoundary;
}

std::vector<HexahedralCell> cuboids_of(const VModel& model) {
  std::vector<HexahedralCell> out(model.num_cells());
  for (std::size_t c = 0; c < out.size(); ++c) {
    out[c].is_reversed = model.is_reversed(c);
    for (std::size_t k = 0; k < 6; ++k) {
      const VFaceRole& role = model.face(c, k);
      out[c].faces[k].kind = kind_of(role);
      if (!role.is_glued()) continue;
      out[c].faces[k].cell = role.mate / 6;
      out[c].faces[k].face = role.mate % 6;
      out[c].faces[k].symmetry = role.symmetry;
    }
    for (std::size_t e = 0; e < 12; ++e) out[c].is_collapsed[e] = model.is_edge_collapsed(c, e);
  }
  return out;
}

// Elements with a key that equal ones share, by key. Joins each one to the first that it equals: join(kept, other)
// says whether they are equal.
template <class Key, class Id, class Join>
void join_equal(std::vector<std::pair<Key, Id>> keys, Join join) {
  std::sort(keys.begin(), keys.end());
  std::vector<Id> kept;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i].first != keys[i - 1].first) kept.clear();
    const Id id = keys[i].second;
    if (std::none_of(kept.begin(), kept.end(), [&](Id first) { return join(first, id); }))
      kept.push_back(id);
  }
}

// The rank of each id in the table, of those that are there.
template <class Id, class T>
std::vector<std::uint32_t> dense_ids(const IdTable<Id, T>& table) {
  std::vector<std::uint32_t> out(table.end_id());
  std::uint32_t next = 0;
  for (const Id id : table) out[id.value] = next++;
  return out;
}

class EqualElements {
 public:
  EqualElements(const VModel& model, HexahedralVComplex& out) : model_(model), out_(out) {
    const VComplexTables& t = out.complex.tables();
    corner_of_.resize(t.points.end_id());
    edge_of_.resize(t.curves.end_id());
    for (std::size_t c = model.num_cells(); c-- > 0;) {
      for (std::size_t i = 8; i-- > 0;) corner_of_[out.points[c][i].value] = {c, i};
      for (std::size_t e = 12; e-- > 0;)
        if (!out.curves[c][e].is_none())
          edge_of_[out.curves[c][e].value] = VEdge{&model.cell(c), e};
    }
    for (const VPointId p : t.points) point_.push_back(p);
    for (const VCurveId c : t.curves) curve_.emplace_back(c, false);
  }

  void identify_points() {
    std::vector<std::array<Rational, 3>> at;
    std::vector<std::pair<std::uint64_t, VPointId>> keys;
    for (const auto& [cell, corner] : corner_of_) {
      at.push_back(v_corner_point(model_.cell(cell), corner));
      keys.emplace_back(internal::point_hash(at.back()),
                        VPointId{static_cast<std::uint32_t>(keys.size())});
    }
    join_equal(std::move(keys), [&](VPointId kept, VPointId other) {
      if (at[kept.value] != at[other.value]) return false;
      const Status done = veritope::identify_points(out_.complex, kept, other);
      VT_CHECK(done.has_value(), "two V-points that cannot be one");
      point_[other.value] = kept;
      return true;
    });
  }

  void identify_curves() {
    using Key = std::array<std::uint64_t, 3>;  // both ends, and a hash where there are several such
    std::vector<std::pair<Key, VCurveId>> keys;
    for (const VCurveId c : out_.complex.tables().curves) {
      const auto& ends = out_.complex.curve(c).ends;
      keys.push_back(
          {Key{std::min(ends[0].value, ends[1].value), std::max(ends[0].value, ends[1].value), 0},
           c});
    }
    std::sort(keys.begin(), keys.end());
    std::vector<bool> is_alone(keys.size());
    const auto differ = [&](std::size_t i, std::size_t j) {
      return j >= keys.size() || keys[i].first != keys[j].first;
    };
    for (std::size_t i = 0; i < keys.size(); ++i)
      is_alone[i] = (i == 0 || differ(i, i - 1)) && differ(i, i + 1);
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (!is_alone[i]) keys[i].first[2] = internal::edge_hash(edge_of_[keys[i].second.value]);
    join_equal(std::move(keys), [&](VCurveId kept, VCurveId other) { return join(kept, other); });
  }

  void renumber() {
    const VComplexTables& t = out_.complex.tables();
    const auto points = dense_ids(t.points);
    const auto curves = dense_ids(t.curves);
    for (std::size_t c = 0; c < model_.num_cells(); ++c) {
      for (VPointId& p : out_.points[c]) p.value = points[point_[p.value].value];
      for (std::size_t e = 0; e < 12; ++e) {
        VCurveId& curve = out_.curves[c][e];
        if (curve.is_none()) continue;
        const auto& [kept, is_reversed] = curve_[curve.value];
        out_.is_edge_reversed[c][e] = out_.is_edge_reversed[c][e] != is_reversed;
        curve.value = curves[kept.value];
      }
    }
    out_.complex = compacted(out_.complex);
  }

 private:
  bool join(VCurveId kept, VCurveId other) {
    const auto reversed = internal::is_equal_reversed(edge_of_[kept.value], edge_of_[other.value]);
    if (!reversed) return false;
    const Status done = veritope::identify_curves(out_.complex, kept, other, *reversed);
    VT_CHECK(done.has_value(), "two equal V-curves with different ends");
    curve_[other.value] = {kept, *reversed};
    return true;
  }

  const VModel& model_;
  HexahedralVComplex& out_;
  std::vector<std::array<std::size_t, 2>> corner_of_;  // cell and corner, the least ones
  std::vector<VEdge> edge_of_;                         // the least ones
  std::vector<VPointId> point_;                        // which one it is made one with
  std::vector<std::pair<VCurveId, bool>> curve_;       // ... and whether it runs against that one
};

}  // namespace

Result<HexahedralVComplex> v_complex_of(const VModel& model) {
  Result<HexahedralVComplex> out = hexahedral_v_complex(cuboids_of(model));
  if (!out) return out;
  EqualElements equal(model, *out);
  equal.identify_points();
  equal.identify_curves();
  equal.renumber();
  return out;
}

}  // namespace veritope
