// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solids/dms/dms_table.h"
#include "solids/dms/fast/fast_region_internal.h"

namespace veritope::internal {
namespace {

// Far above every rounding error of sums and products of a few numbers, relative to the sizes of the terms.
constexpr double kSlack = 0x1p-30;

struct FastCorner {
  Point3d at;  // local coordinates of the cell
  std::uint32_t vertex;
  bool is_vertex;
};

class FastParting {
 public:
  FastParting(const FastTables& tables, const TetrahedronCorners& corners, const FastCell& cell,
              const TetrahedronCorners& of_cell)
      : tables_(tables), cell_(cell), of_cell_(of_cell) {
    for (std::size_t m = 0; m < 4; ++m) at_of_cell_[m] = {local(cell.corners[m]), of_cell[m], true};
    for (std::size_t k = 0; k < tables.knots.size(); ++k) {
      if (!tables.is_used[k]) continue;
      const std::size_t corner = k / kKnotsOfCorner;
      knots_[k] = {local(tables.knots[k]), corners[corner], k % kKnotsOfCorner == 0};
      for (std::size_t m = 0; m < 4; ++m) high_[k][m] = high(k, m);
    }
  }
  /// An upper bound of the knot's barycentric coordinate m, and of those of points beside it.
  const std::array<double, 4>& high(std::size_t knot) const { return high_[knot]; }

  /// Whether a plane that has the knots on one closed side and the cell on the other is seen.
  bool is_parted(const KnotSet& set) const {
    for (std::size_t m = 0; m < 4; ++m)
      if (std::all_of(set.begin(), set.end(), [&](KnotNumber k) { return high_[k][m] <= 0; }))
        return true;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& boxes = tables_.knot_boxes;
      if (std::all_of(set.begin(), set.end(),
                      [&](KnotNumber k) { return boxes[k].hi[c] <= cell_.box.lo[c]; }) ||
          std::all_of(set.begin(), set.end(),
                      [&](KnotNumber k) { return boxes[k].lo[c] >= cell_.box.hi[c]; }))
        return true;
    }
    return false;
  }
  /// Whether a plane through three knots of the set does so. @cost cubic in their number
  bool is_parted_by_knots(const KnotSet& set) const {
    std::vector<const FastCorner*> all;
    for (std::size_t i = 0; i < set.size(); ++i)
      if (i == 0 || set[i] != set[i - 1]) all.push_back(&knots_[set[i]]);
    if (all.size() > kMaxKnots) return false;
    for (std::size_t a = 0; a < all.size(); ++a)
      for (std::size_t b = a + 1; b < all.size(); ++b)
        for (std::size_t c = b + 1; c < all.size(); ++c)
          if (plane_parts(all, {all[a], all[b], all[c]})) return true;
    return false;
  }

 private:
  static constexpr std::size_t kMaxKnots = 8;

  Point3d local(const Point3d& p) const {
    Point3d out;
    for (std::size_t c = 0; c < 3; ++c) out[c] = (p[c] - cell_.place.origin[c]) * cell_.place.scale;
    return out;
  }
  double high(std::size_t k, std::size_t m) const {
    if (knots_[k].is_vertex)
      for (std::size_t i = 0; i < 4; ++i)
        if (of_cell_[i] == knots_[k].vertex) return i == m ? 2 : 0;
    const FastLinear& f = cell_.frame.lambda[m];
    double value = f.c[0], size = 1 + std::abs(f.c[0]);
    for (std::size_t c = 0; c < 3; ++c) {
      const double far = std::abs(tables_.knots[k][c]) * cell_.place.scale;
      value += f.c[c + 1] * knots_[k].at[c];
      size += std::abs(f.c[c + 1]) * (std::abs(knots_[k].at[c]) + far * 0x1p-10);
    }
    return value + (size * kSlack + (f.error[0] + f.error[1]));
  }

  // The plane of three knots parts the set from the cell, with a margin for all points that are not in it by name.
  bool plane_parts(const std::vector<const FastCorner*>& all,
                   const std::array<const FastCorner*, 3>& three) const {
    double e[2][3], reach = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < 2; ++i) e[i][c] = three[i + 1]->at[c] - three[0]->at[c];
      for (const FastCorner* p : all) reach = std::max(reach, std::abs(p->at[c]));
      for (const FastCorner& p : at_of_cell_) reach = std::max(reach, std::abs(p.at[c]));
    }
    const double n[3] = {e[0][1] * e[1][2] - e[0][2] * e[1][1],
                         e[0][2] * e[1][0] - e[0][0] * e[1][2],
                         e[0][0] * e[1][1] - e[0][1] * e[1][0]};
    double far = 0;
    for (std::size_t c = 0; c < 3; ++c)
      far = std::max(far, std::abs(cell_.place.origin[c]) * cell_.place.scale);
    const double size = reach + far * 0x1p-10, margin = size * size * size * kSlack;
    int side = 0;
    const auto is_beside = [&](const FastCorner& p, int wanted) {
      for (const FastCorner* q : three)
        if (q == &p || (q->is_vertex && p.is_vertex && q->vertex == p.vertex)) return true;
      double h = 0;
      for (std::size_t c = 0; c < 3; ++c) h += n[c] * (p.at[c] - three[0]->at[c]);
      if (!(std::abs(h) > margin)) return false;
      const int here = (h > 0 ? 1 : -1) * wanted;
      if (side == 0) side = here;
      return side == here;
    };
    return std::all_of(all.begin(), all.end(),
                       [&](const FastCorner* p) { return is_beside(*p, 1); }) &&
           std::all_of(at_of_cell_.begin(), at_of_cell_.end(),
                       [&](const FastCorner& p) { return is_beside(p, -1); });
  }

  const FastTables& tables_;
  const FastCell& cell_;
  const TetrahedronCorners& of_cell_;
  std::array<FastCorner, 4> at_of_cell_{};
  std::array<FastCorner, 4 * kKnotsOfCorner> knots_{};
  std::array<std::array<double, 4>, 4 * kKnotsOfCorner> high_{};
};

// Takes what the wanted tops need out of the tables.
class FastPruning {
 public:
  FastPruning(const FastTables& tables, const FastParting& parting, bool is_own)
      : tables_(tables),
        parting_(parting),
        is_own_(is_own),
        leaf_places_(tables.leaves.size()),
        node_places_(tables.nodes.size()) {}

  void add(const FastTables::Top& top) {
    mark(top.at);
    for (const FastId part : top.part) mark(part);
    wanted_.push_back(&top);
  }

  std::unique_ptr<FastRegionUnit> run() {
    auto out = std::make_unique<FastRegionUnit>();
    for (std::size_t i = 0; i < leaf_places_.size(); ++i) {
      if (!leaf_places_[i] || (!is_own_ && parting_.is_parted(tables_.leaf_sets[i]))) {
        leaf_places_[i] = 0;
        continue;
      }
      out->leaf_ids.push_back(static_cast<std::uint32_t>(i));
      leaf_places_[i] = static_cast<std::uint32_t>(out->leaf_ids.size());
    }
    frames_.assign(tables_.frames.size(), std::nullopt);
    for (std::size_t i = 0; i < node_places_.size(); ++i) {
      if (!node_places_[i]) continue;
      const FastTables::Node& from = tables_.nodes[i];
      FastNode node{};
      bool is_zero = true;
      for (std::size_t m = 0; m < 4; ++m) {
        node.part[m] = place(from.part[m]);
        is_zero = is_zero && node.part[m] == 0;
      }
      node_places_[i] = 0;
      if (is_zero) continue;
      node.frame = frame(from.frame, *out);
      out->nodes.push_back(node);
      node_places_[i] = static_cast<std::uint32_t>(out->leaf_ids.size() + out->nodes.size());
    }
    for (const FastTables::Top* top : wanted_) add_top(*top, *out);
    return out;
  }

 private:
  void mark(FastId id) {
    if (id == 0) return;
    if (id % 2 == 1) {
      leaf_places_[id / 2] = 1;
      return;
    }
    std::uint32_t& place = node_places_[id / 2 - 1];
    if (place != 0) return;
    place = 1;
    for (const FastId part : tables_.nodes[id / 2 - 1].part) mark(part);
  }
  std::uint32_t place(FastId id) const {
    if (id == 0) return 0;
    return id % 2 == 1 ? leaf_places_[id / 2] : node_places_[id / 2 - 1];
  }
  std::uint32_t frame(std::uint32_t number, FastRegionUnit& out) {
    if (!frames_[number]) {
      frames_[number] = static_cast<std::uint32_t>(out.frame_ids.size());
      out.frame_ids.push_back(number);
    }
    return *frames_[number];
  }
  void add_top(const FastTables::Top& from, FastRegionUnit& out) {
    FastTop top{};
    top.at = place(from.at);
    bool is_zero = top.at == 0;
    for (std::size_t m = 0; m < 4; ++m) {
      top.part[m] = place(from.part[m]);
      is_zero = is_zero && top.part[m] == 0;
    }
    if (is_zero) return;
    if (!tables_.is_separate) top.frame = frame(from.frame, out);
    top.number = static_cast<std::uint32_t>(&from - tables_.tops.data());
    out.tops.push_back(top);
    for (const KnotNumber k : from.set)
      for (std::size_t m = 0; m < 4; ++m) out.high[m] = std::max(out.high[m], parting_.high(k)[m]);
  }

  const FastTables& tables_;
  const FastParting& parting_;
  bool is_own_;
  std::vector<std::uint32_t> leaf_places_, node_places_;  // first 1 for what is wanted
  std::vector<std::optional<std::uint32_t>> frames_;
  std::vector<const FastTables::Top*> wanted_;
};

void connect(const FastTables& tables, std::size_t components, FastRegionUnit& out) {
  FastUnit& u = out.unit;
  u.leaves = tables.leaves.data(), u.frames = tables.frames.data();
  u.leaf_ids = out.leaf_ids.data(), u.frame_ids = out.frame_ids.data();
  u.nodes = out.nodes.data(), u.tops = out.tops.data();
  u.num_leaves = out.leaf_ids.size(), u.num_frames = out.frame_ids.size();
  u.num_nodes = out.nodes.size(), u.num_tops = out.tops.size();
  u.value = tables.value.data(), u.value_weight = tables.value_weight.data();
  u.gradient = tables.gradient.data(), u.gradient_weight = tables.gradient_weight.data();
  std::copy_n(tables.place.origin, 3, u.origin);
  u.scale = tables.place.scale;
  u.components = components;
  u.is_separate = tables.is_separate;
  out.tables = &tables;
  out.box = tables.place.box;
}

}  // namespace

std::size_t FastRegion::bytes() const {
  std::size_t sum = sizeof(FastRegion);
  for (const auto& u : units)
    sum += sizeof(FastRegionUnit) + 4 * (u->leaf_ids.size() + u->frame_ids.size()) +
           sizeof(FastNode) * u->nodes.size() + sizeof(FastTop) * u->tops.size() + 64;
  return sum;
}

std::unique_ptr<FastRegionUnit> make_fast_unit(const FastTables& tables,
                                               const TetrahedronCorners& corners,
                                               const FastCell& cell,
                                               const TetrahedronCorners& of_cell,
                                               std::size_t components) {
  const bool is_own = &corners == &of_cell;
  FastParting parting(tables, corners, cell, of_cell);
  FastPruning pruning(tables, parting, is_own);
  for (const FastTables::Top& top : tables.tops)
    if (is_own || !(parting.is_parted(top.set) || parting.is_parted_by_knots(top.set)))
      pruning.add(top);
  auto out = pruning.run();
  out->is_own = is_own;
  connect(tables, components, *out);
  return out->tops.empty() ? nullptr : std::move(out);
}

}  // namespace veritope::internal
