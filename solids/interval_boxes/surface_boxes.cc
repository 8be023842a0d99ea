// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/surface_boxes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "solids/interval_boxes/box_sets_internal.h"
#include "solids/interval_boxes/conditions.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
constexpr std::uint64_t kWhole = std::uint64_t{1}
                                 << 48;  // parameters of edges: integers times 2^-48

// A stretch of an edge, in the direction of travel of its first side, and a piece that has it as a side (or a point of
// it).
struct Contact {
  std::uint32_t edge;
  std::uint64_t begin, end;
  Id piece;
  friend bool operator<(const Contact& a, const Contact& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    if (a.begin != b.begin) return a.begin < b.begin;
    return a.end != b.end ? b.end < a.end : a.piece < b.piece;  // longer ones first
  }
};

// Pieces around one stretch.
struct Group {
  std::uint32_t edge;
  std::uint64_t begin, end;
  std::vector<Id> pieces;
};

class CoverMaker {
 public:
  CoverMaker(BoundaryModel& model, double eps, const SurfaceBoxOptions& options)
      : model_(model), forest_(model.forest()), options_(options) {
    eps_ = std::ldexp(eps, forest_.scale());
    margin_ = options.margin * eps_;
    out_.eps = eps;
  }

  Result<SurfaceCover> run() {
    for (std::uint32_t r = 0; r < forest_.num_roots(); ++r)
      if (!descend(forest_.root(r))) return too_many();
    for (;;) {
      make_groups();
      std::set<Id> split;
      for (const Group& g : groups_)
        if (size_of(grown(g.pieces)) > eps_) add_largest(g.pieces, &split);
      if (split.empty()) break;
      for (const Id id : split) {
        leaves_.erase(id);
        if (forest_.node(id).level >= options_.max_level || !forest_.may_split(id))
          return too_many();
        const Id first = forest_.children(id);
        for (Id k = 0; k < 4; ++k)
          if (!descend(first + k)) return too_many();
      }
    }
    make_boxes();
    make_clusters();
    return std::move(out_);
  }

 private:
  Error too_many() const {
    if (forest_.is_out_of_memory()) return memory_error(*forest_.budget());
    return Error{Code::kOverLimit,
                 {},
                 leaves_.size() > options_.max_boxes
                     ? "over " + std::to_string(options_.max_boxes) + " pieces"
                     : "pieces below level " + std::to_string(options_.max_level)};
  }

  // For a planar model, one layer of the wall's pieces is kept: those that reach up from height 0.
  bool is_wanted(const PieceForest::Node& node) const {
    if (!model_.is_planar()) return true;
    return node.patch % 3 == 1 && node.hull.lo[2] <= 0 && node.hull.hi[2] > 0 &&
           (approx_centre(node.hull)[2] > 0 || node.level == 0);
  }
  bool is_small(const PieceForest::Node& node) const {
    if (model_.is_planar() && node.level < 2) return false;
    return size_of(grown(node.hull)) <= eps_;
  }
  double size_of(const Box3d& b) const { return veritope::size_of(b, model_.dimension()); }

  bool descend(Id id) {
    const PieceForest::Node node = forest_.node(id);
    if (!is_wanted(node)) return true;
    if (is_small(node)) {
      leaves_.insert(id);
      return leaves_.size() <= options_.max_boxes;
    }
    if (node.level >= options_.max_level || !forest_.may_split(id)) return false;
    const Id first = forest_.children(id);
    for (Id k = 0; k < 4; ++k)
      if (!descend(first + k)) return false;
    return true;
  }

  void add_largest(const std::vector<Id>& pieces, std::set<Id>* to) const {
    double most = 0;
    for (const Id id : pieces) most = std::max(most, size_of(forest_.node(id).hull));
    for (const Id id : pieces)
      if (size_of(forest_.node(id).hull) >= 0.75 * most) to->insert(id);
  }

  Box3d grown(const std::vector<Id>& pieces) const {
    Box3d b = forest_.node(pieces.front()).hull;
    for (const Id id : pieces) b = hull(b, forest_.node(id).hull);
    return grown(b);
  }
  Box3d grown(Box3d b) const {
    for (std::size_t k = 0; k < 3; ++k) b.lo[k] -= margin_, b.hi[k] += margin_;
    return b;
  }

  // Adds the stretches and points where the piece touches sides of its patch; a piece at a pole goes to `poles_`.
  void add_contacts(Id id) {
    const PieceForest::Node& node = forest_.node(id);
    const PieceForest::Form& form = forest_.form(node.patch);
    const std::uint32_t sides = form.shape.is_triangle ? 3 : 4;
    for (std::uint32_t s = 0; s < sides; ++s) {
      std::uint64_t begin, end;  // in the side's direction of travel
      if (form.shape.is_triangle) {
        const std::uint64_t unit = kWhole >> node.level, sum = std::uint64_t{1} << node.level;
        const std::uint64_t a = (node.is_upside_down ? sum + 1 : sum - 1) - node.i - node.j;
        const std::uint64_t x[3] = {a, node.i, node.j};
        const std::uint64_t along = x[(s + 1) % 3];
        if (node.is_upside_down) {
          if (x[(s + 2) % 3] != 1) continue;
          begin = end = along * unit;
        } else {
          if (!forest_.side_of_patch(node, s)) continue;
          begin = along * unit, end = begin + unit;
        }
      } else {
        if (!forest_.side_of_patch(node, s)) continue;
        const std::size_t axis = s % 2;
        const std::uint64_t unit = kWhole >> (form.root_bits[axis] + node.level);
        begin = (axis == 0 ? node.i : node.j) * unit, end = begin + unit;
        if (s >= 2) std::tie(begin, end) = std::pair(kWhole - end, kWhole - begin);
      }
      const PatchSide side{node.patch, s};
      const PatchComplex& complex = model_.complex();
      if (model_.is_planar() && s % 2 == 0) continue;
      if (complex.is_collapsed(side)) {
        poles_.insert(id);
        continue;
      }
      const std::uint32_t edge = complex.edge(side);
      if (complex.sides(edge)[0] != side)
        std::tie(begin, end) = std::pair(kWhole - end, kWhole - begin);
      contacts_.push_back({edge, begin, end, id});
    }
  }

  void make_groups() {
    contacts_.clear(), groups_.clear(), poles_.clear();
    for (const Id id : leaves_) add_contacts(id);
    std::sort(contacts_.begin(), contacts_.end());
    // Stretches are nested or apart; points come after the stretches that begin there, or lie at the end of the last
    // one.
    for (const Contact& c : contacts_) {
      if (!groups_.empty() && groups_.back().edge == c.edge && c.end <= groups_.back().end)
        groups_.back().pieces.push_back(c.piece);
      else if (c.begin < c.end)
        groups_.push_back({c.edge, c.begin, c.end, {c.piece}});
    }
  }

  void add_box(SurfaceBox::Kind kind, std::uint32_t entity, std::vector<Id> pieces) {
    SurfaceBox b{kind, {}, entity, std::move(pieces)};
    const Box3d box = grown(b.pieces);
    out_.largest = std::max(out_.largest, std::ldexp(size_of(box), -forest_.scale()));
    b.box = model_.from_forest(box);
    out_.boxes.push_back(std::move(b));
  }

  void make_boxes() {
    std::set<Id> on_edges = poles_;
    for (const Contact& c : contacts_) on_edges.insert(c.piece);
    for (const Id id : leaves_)
      if (!on_edges.contains(id)) add_box(SurfaceBox::Kind::kFace, forest_.node(id).patch, {id});
    first_edge_box_ = out_.boxes.size();
    const auto edge_kind = model_.is_planar() ? SurfaceBox::Kind::kVertex : SurfaceBox::Kind::kEdge;
    for (Group& g : groups_) add_box(edge_kind, g.edge, g.pieces);
    for (const Id id : poles_) add_box(SurfaceBox::Kind::kVertex, vertex_of_pole(id), {id});
  }

  std::uint32_t vertex_of_pole(Id id) const {
    const PieceForest::Node& node = forest_.node(id);
    for (std::uint32_t s = 0;; ++s)
      if ((forest_.form(node.patch).collapsed >> s & 1) != 0 && forest_.side_of_patch(node, s))
        return model_.complex().vertex({node.patch, s});
  }

  // The vertices at the ends of an edge, as its first side has them.
  std::array<std::uint32_t, 2> ends(std::uint32_t edge) const {
    const PatchComplex& complex = model_.complex();
    const PatchSide side = complex.sides(edge)[0];
    const std::uint32_t n = complex.patch(side.patch).num_sides();
    return {complex.vertex({side.patch, side.side}),
            complex.vertex({side.patch, (side.side + 1) % n})};
  }

  void make_clusters() {
    if (model_.is_planar()) return;
    std::map<std::uint32_t, std::set<std::uint32_t>> members;  // by vertex
    // The boxes of stretches that end in the vertex hold it.
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const auto box = static_cast<std::uint32_t>(first_edge_box_ + g);
      const auto at = ends(groups_[g].edge);
      if (groups_[g].begin == 0) members[at[0]].insert(box);
      if (groups_[g].end == kWhole) members[at[1]].insert(box);
    }
    // Intersections of boxes of two chains, joined where they meet.
    std::vector<Box3d> chain;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      chain.push_back(out_.boxes[first_edge_box_ + g].box);
    std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 2>>> pairs;
    for (const auto& [i, j] : meeting_pairs(chain)) {
      if (groups_[i].edge == groups_[j].edge) continue;
      const auto a = ends(groups_[i].edge), b = ends(groups_[j].edge);
      std::set<std::uint32_t> common;
      for (const std::uint32_t v : a)
        if (v == b[0] || v == b[1]) common.insert(v);
      for (const std::uint32_t v : common) pairs[v].push_back({i, j});
    }
    for (auto& [vertex, boxes] : members) {
      grow(pairs[vertex], chain, &boxes);
      out_.clusters.push_back({vertex, {boxes.begin(), boxes.end()}});
      for (const std::uint32_t b : boxes)
        out_.boxes[b].kind = SurfaceBox::Kind::kVertex, out_.boxes[b].entity = vertex;
    }
  }

  void grow(const std::vector<std::array<std::uint32_t, 2>>& pairs, const std::vector<Box3d>& chain,
            std::set<std::uint32_t>* members) const {
    const auto first = static_cast<std::uint32_t>(first_edge_box_);
    std::vector<Box3d> component;
    std::vector<bool> is_in(pairs.size(), false);
    const auto add = [&](std::size_t p) {
      is_in[p] = true;
      component.push_back(common_part(chain[pairs[p][0]], chain[pairs[p][1]]));
      members->insert(first + pairs[p][0]);
      members->insert(first + pairs[p][1]);
    };
    for (std::size_t p = 0; p < pairs.size(); ++p)
      if (members->contains(first + pairs[p][0]) && members->contains(first + pairs[p][1])) add(p);
    for (std::size_t n = 0; n < component.size(); ++n)
      for (std::size_t p = 0; p < pairs.size(); ++p)
        if (!is_in[p] && meets(component[n], common_part(chain[pairs[p][0]], chain[pairs[p][1]])))
          add(p);
  }

  BoundaryModel& model_;
  PieceForest& forest_;
  const SurfaceBoxOptions& options_;
  double eps_ = 0, margin_ = 0;
  std::set<Id> leaves_, poles_;
  std::vector<Contact> contacts_;
  std::vector<Group> groups_;
  std::size_t first_edge_box_ = 0;
  SurfaceCover out_;
};

}  // namespace

const char* to_string(SurfaceBox::Kind kind) {
  return kind == SurfaceBox::Kind::kFace   ? "face"
         : kind == SurfaceBox::Kind::kEdge ? "edge"
                                           : "vertex";
}

std::vector<Box3d> SurfaceCover::plain_boxes() const {
  std::vector<Box3d> out;
  for (const SurfaceBox& b : boxes) out.push_back(b.box);
  return out;
}

Result<SurfaceCover> make_surface_cover(BoundaryModel& model, double eps,
                                        const SurfaceBoxOptions& options) {
  const double scaled = std::ldexp(eps, model.forest().scale());
  if (!(eps > 0) || !std::isfinite(scaled) || !(scaled > 0x1p-30))
    return Error{
        Code::kBadArgument,
        {},
        "eps = " + std::to_string(eps) + " is not positive, or too small or large for the model"};
  if (!(options.margin > 0 && options.margin < 0.5))
    return Error{Code::kBadArgument,
                 {},
                 "margin = " + std::to_string(options.margin) + " is not between 0 and 1/2"};
  return CoverMaker(model, eps, options).run();
}

}  // namespace veritope
