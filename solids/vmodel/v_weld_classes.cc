// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_weld_classes_internal.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "solids/vmodel/v_edge_internal.h"
#include "solids/vmodel/v_face_parts_internal.h"
#include "solids/vmodel/v_parts.h"

namespace veritope::internal {
namespace {

// Corners of the cells, both ends of side n of f and what the symmetry makes of them in g.
struct TiedSide {
  std::array<std::uint32_t, 2> own, other;
  std::uint32_t edge, other_edge;
  bool flips;
};
TiedSide tied_side(VFaceNumber f, VFaceNumber g, unsigned symmetry, std::size_t n) {
  TiedSide out{};
  std::array<std::uint32_t, 2> own{}, other{};
  for (std::size_t end = 0; end < 2; ++end) {
    own[end] = corner_of_face(f % 6, kSidesOfFace[n][end]);
    other[end] = corner_of_face(g % 6, v_symmetry_image(symmetry, kSidesOfFace[n][end]));
    out.own[end] = 8 * (f / 6) + own[end];
    out.other[end] = 8 * (g / 6) + other[end];
  }
  out.edge = 12 * (f / 6) + edge_between(own[0], own[1]);
  out.other_edge = 12 * (g / 6) + edge_between(other[0], other[1]);
  out.flips = other[0] > other[1];
  return out;
}

bool is_collapsed_edge(const VModel& model, std::uint32_t edge) {
  return model.is_edge_collapsed(edge / 12, edge % 12);
}

// Runs of two or more entries with one key, sorted.
template <typename Key, typename Visit>
void for_each_run(const std::vector<std::pair<Key, std::uint32_t>>& keys, Visit visit) {
  for (std::size_t i = 0, end = 1; i < keys.size(); end = i + 1) {
    while (end < keys.size() && keys[end].first == keys[i].first) ++end;
    if (end - i > 1) visit(i, end);
    i = end;
  }
}

}  // namespace

WeldClasses::WeldClasses(const VModel& model)
    : model_(&model), corners_(8 * model.num_cells()), edges_(12 * model.num_cells()) {
  for (VFaceNumber f = 0; f < model.num_faces(); ++f) {
    const VFaceRole& role = model.face(f);
    if (role.is_glued() && role.mate > f) tie_sides(f, role.mate, role.symmetry);
  }
  tie_equal_corners();
  tie_equal_edges();
  is_tied_corner_.assign(8 * model.num_cells(), false);
  is_tied_edge_.assign(12 * model.num_cells(), false);
}

void WeldClasses::tie_sides(VFaceNumber f, VFaceNumber g, unsigned symmetry) {
  for (std::size_t n = 0; n < 4; ++n) {
    const TiedSide side = tied_side(f, g, symmetry, n);
    for (std::size_t end = 0; end < 2; ++end) corners_.join(side.own[end], side.other[end]);
    if (!is_collapsed_edge(*model_, side.edge)) edges_.tie(side.edge, side.other_edge, side.flips);
  }
}

void WeldClasses::tie_equal_corners() {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  const auto at = [&](std::uint32_t corner) {
    return v_corner_point(model_->cell(corner / 8), corner % 8);
  };
  for (std::uint32_t c = 0; c < corners_.size(); ++c)
    if (corners_.find(c) == c) keys.emplace_back(point_hash(at(c)), c);
  std::sort(keys.begin(), keys.end());
  for_each_run(keys, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin + 1; i < end; ++i)
      for (std::size_t j = begin; j < i; ++j)
        if (at(keys[i].second) == at(keys[j].second)) {
          corners_.join(keys[i].second, keys[j].second);
          break;
        }
  });
}

void WeldClasses::tie_equal_edges() {
  using Key = std::array<std::uint64_t, 3>;  // both ends, and a hash where there are several such
  const auto edge = [&](std::uint32_t e) { return VEdge{&model_->cell(e / 12), e % 12}; };
  std::vector<std::pair<Key, std::uint32_t>> keys;
  for (std::uint32_t e = 0; e < 12 * model_->num_cells(); ++e) {
    if (is_collapsed_edge(*model_, e) || edges_.find(e).axis != e) continue;
    const auto ends = ends_of_edge(e % 12);
    const std::uint32_t a = corners_.find(8 * (e / 12) + ends[0]),
                        b = corners_.find(8 * (e / 12) + ends[1]);
    keys.push_back({{std::min(a, b), std::max(a, b), 0}, e});
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::pair<Key, std::uint32_t>> hashed;
  for_each_run(keys, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      keys[i].first[2] = edge_hash(edge(keys[i].second));
      hashed.push_back(keys[i]);
    }
  });
  keys = std::move(hashed);
  std::sort(keys.begin(), keys.end());
  for_each_run(keys, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin + 1; i < end; ++i)
      for (std::size_t j = begin; j < i; ++j)
        if (const auto flips = is_equal_reversed(edge(keys[j].second), edge(keys[i].second))) {
          edges_.tie(keys[j].second, keys[i].second, *flips);
          break;
        }
  });
}

WeldClasses::Range WeldClasses::range_of(std::uint32_t corner_class) const {
  const auto known = ranges_.find(corner_class);
  if (known != ranges_.end()) return known->second;
  const auto at = v_corner_point(model_->cell(corner_class / 8), corner_class % 8);
  return {at, at};
}

std::optional<VApartReason> WeldClasses::tie(const NearPair& pair, const Rational& eps) {
  std::array<TiedSide, 4> sides;
  for (std::size_t n = 0; n < 4; ++n) {
    sides[n] = tied_side(pair.f, pair.g, pair.symmetry, n);
    if (is_collapsed_edge(*model_, sides[n].edge) !=
        is_collapsed_edge(*model_, sides[n].other_edge))
      return VApartReason::kCollapse;
  }
  // The classes of the eight corners, first among themselves.
  std::vector<std::uint32_t> classes;
  const auto place = [&](std::uint32_t corner) {
    const std::uint32_t root = corners_.find(corner);
    const auto at = std::find(classes.begin(), classes.end(), root);
    if (at != classes.end()) return static_cast<std::uint32_t>(at - classes.begin());
    classes.push_back(root);
    return static_cast<std::uint32_t>(classes.size() - 1);
  };
  DisjointSets<> groups(8);
  for (const TiedSide& side : sides)
    for (std::size_t end = 0; end < 2; ++end)
      groups.join(place(side.own[end]), place(side.other[end]));
  std::array<std::optional<Range>, 8> ranges;
  for (std::uint32_t i = 0; i < classes.size(); ++i) {
    Range own = range_of(classes[i]);
    std::optional<Range>& all = ranges[groups.find(i)];
    if (!all) {
      all = std::move(own);
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      all->low[c] = std::min(all->low[c], own.low[c]);
      all->high[c] = std::max(all->high[c], own.high[c]);
      if (all->high[c] - all->low[c] > eps + eps) return VApartReason::kTooFar;
    }
  }
  for (const TiedSide& side : sides) {
    for (std::size_t end = 0; end < 2; ++end) corners_.join(side.own[end], side.other[end]);
    if (is_collapsed_edge(*model_, side.edge)) continue;
    edges_.tie(side.edge, side.other_edge, side.flips);
    is_tied_edge_[edges_.find(side.edge).axis] = true;
  }
  for (std::uint32_t i = 0; i < classes.size(); ++i) {
    if (groups.find(i) != i) continue;
    const std::uint32_t root = corners_.find(classes[i]);
    is_tied_corner_[root] = true;
    ranges_.insert_or_assign(root, std::move(*ranges[i]));
  }
  return std::nullopt;
}

}  // namespace veritope::internal
