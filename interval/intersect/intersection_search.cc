// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/intersection_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/enclosure/patch_tree.h"
#include "robust/base/box3d.h"
#include "robust/base/disjoint_sets.h"

namespace veritope {
namespace {

using Id = PatchTree::Id;
struct Pair {
  Id a, b;
  std::uint32_t parent = 0;  // in the round before
};

constexpr std::size_t kMostComparisons = 50'000'000;
/// By how much tubes reach beyond the box that they are made for, as fractions of its length.
constexpr double kLongReach = 0.35, kShortReach = 0.125;

using internal::approx_middle;
double size_of(const Box3& box) {
  return std::max(
      {box[0].hi() - box[0].lo(), box[1].hi() - box[1].lo(), box[2].hi() - box[2].lo()});
}

/// The range of n . p over the control points of a net; unknown if a weight may not be positive.
struct Slab {
  Interval range;
  bool is_known = true;
};
Slab project(const EnclosedSurface& surface, const Interval* net,
             const std::array<Interval, 3>& n) {
  const std::size_t count = surface.net_count();
  Slab out{Interval::empty()};
  for (std::size_t k = 0; k < count; ++k) {
    Interval d = n[0] * net[k] + n[1] * net[count + k] + n[2] * net[2 * count + k];
    if (surface.is_rational()) {
      const Interval& w = net[3 * count + k];
      if (w.sign() != Sign3::kPositive) return {Interval::entire(), false};
      d = d / w;
    }
    out.range = k == 0 ? d : hull(out.range, d);
  }
  return out;
}

Point3d cross(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The direction, scaled; nothing if it is zero or not finite.
std::optional<std::array<Interval, 3>> usable(const Point3d& d) {
  const double scale = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  return std::array<Interval, 3>{Interval(d[0] / scale), Interval(d[1] / scale),
                                 Interval(d[2] / scale)};
}

/// Directions that may separate two nodes seen as parallelograms: both normals, and the directions across a side of
/// each, which also separate what lies in one plane. An affine map of space maps them along.
std::array<Point3d, 6> separating_directions(const PatchTree::Node& a, const PatchTree::Node& b) {
  const Point3d u = approx_middle(a.du), v = approx_middle(a.dv), s = approx_middle(b.du),
                t = approx_middle(b.dv);
  return {cross(u, v), cross(s, t), cross(u, s), cross(v, t), cross(u, t), cross(v, s)};
}

class PairSearch {
 public:
  PairSearch(const EnclosedSurface& s1, const EnclosedSurface& s2, const IntersectionBudget& budget)
      : budget_(budget),
        limit_(budget.pairs_in_cluster +
               budget.pairs_per_piece *
                   (s1.num_spans(0) * s1.num_spans(1) + s2.num_spans(0) * s2.num_spans(1))),
        first_(s1),
        second_(s2) {}

  IntersectionCover run() {
    std::vector<Pair> round{{PatchTree::kRoot, PatchTree::kRoot}}, next;
    while (!round.empty()) {
      next.clear(), cut_.clear();
      for (std::size_t i = 0; i < round.size(); ++i) {
        if (out_.pairs >= budget_.pairs || (i % 256 == 0 && budget_.stop && budget_.stop())) {
          for (; i < round.size(); ++i) give_up(round[i], OpenPair::kBudget);
          for (const Pair& p : next) give_up(p, OpenPair::kBudget);
          next.clear();
          break;
        }
        visit(round[i], &next);
      }
      if (cut_.size() > limit_) give_up_large_clusters(&next);
      round.swap(next);
    }
    drop_what_tubes_hold();
    return std::move(out_);
  }

 private:
  Box4 box_of(const Pair& p) const {
    const auto &a = first_.node(p.a), &b = second_.node(p.b);
    return Box4(Interval::from_bounds(a.u0, a.u1), Interval::from_bounds(a.v0, a.v1),
                Interval::from_bounds(b.u0, b.u1), Interval::from_bounds(b.v0, b.v1));
  }
  /// Records the pair as undecided. At the end drop_what_tubes_hold removes it if a tube holds it, maybe one that was
  /// proved later from other pieces.
  void give_up(const Pair& p, OpenPair reason) {
    out_.undecided.push_back(box_of(p));
    out_.reasons.push_back(reason);
  }
  void drop_what_tubes_hold() {
    if (out_.undecided.size() * out_.tubes.size() > kMostComparisons) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < out_.undecided.size(); ++i) {
      const Box4 x = out_.undecided[i];
      if (std::any_of(out_.tubes.begin(), out_.tubes.end(),
                      [&](const IntersectionTube& t) { return t.contains(x); }))
        continue;
      out_.undecided[kept] = x, out_.reasons[kept] = out_.reasons[i];
      ++kept;
    }
    out_.undecided.resize(kept), out_.reasons.resize(kept);
  }

  void visit(const Pair& p, std::vector<Pair>* next) {
    ++out_.pairs;
    const auto &a = first_.node(p.a), &b = second_.node(p.b);
    if (is_disjoint(a.hull, b.hull)) return;
    if (!a.is_single() || !b.is_single()) {
      const bool cut_first =
          !a.is_single() && (b.is_single() || size_of(a.hull) >= size_of(b.hull));
      split(p, cut_first, !cut_first, next);
      return;
    }
    if (are_apart(p)) return;
    if (!decided_by_tube(p)) cut(p, next);
  }

  bool are_apart(const Pair& p) {
    const auto& first = first_.with_derivatives(p.a);
    const auto& second = second_.with_derivatives(p.b);
    for (const Point3d& d : separating_directions(first, second)) {
      const auto direction = usable(d);
      if (!direction) continue;
      const Slab a = project(first_.surface(), first_.net(p.a), *direction);
      const Slab b = project(second_.surface(), second_.net(p.b), *direction);
      if (a.is_known && b.is_known && is_disjoint(a.range, b.range)) return true;
    }
    return false;
  }

  /// A key of the two pieces in which the nodes of a pair lie.
  std::uint64_t key_of(const Pair& p) const {
    const auto &a = first_.node(p.a), &b = second_.node(p.b);
    const std::uint64_t piece1 = a.i0 * first_.surface().num_spans(1) + a.j0;
    const std::uint64_t piece2 = b.i0 * second_.surface().num_spans(1) + b.j0;
    return piece1 << 32 | piece2;
  }
  bool is_covered(std::uint64_t key, const IntersectionTube& region) const {
    const auto found = tubes_of_pieces_.find(key);
    if (found == tubes_of_pieces_.end()) return false;
    return std::any_of(found->second.rbegin(), found->second.rend(),
                       [&](std::size_t t) { return out_.tubes[t].contains(region); });
  }

  bool decided_by_tube(const Pair& p) {
    const auto &a = first_.node(p.a), &b = second_.node(p.b);
    const EnclosedSurface &s1 = first_.surface(), &s2 = second_.surface();
    IntersectionTube region;
    const Contraction found = contract(s1, s2, box_of(p), a.du, a.dv, b.du, b.dv, &region);
    if (found == Contraction::kEmpty) return true;
    const std::uint64_t key = key_of(p);
    if (found == Contraction::kUnknown) return false;
    if (is_covered(key, region)) return true;
    // A long tube makes those of its neighbours unnecessary.
    for (const double reach : {kLongReach, kShortReach}) {
      ++out_.proofs;
      auto tube = find_tube(s1, s2, region, reach);

      if (!tube) continue;
      tubes_of_pieces_[key].push_back(out_.tubes.size());
      out_.tubes.push_back(std::move(*tube));
      return true;
    }
    return false;
  }

  bool may_cut(const PatchTree& tree, Id id) const {
    const auto& n = tree.node(id);
    const auto& s = tree.surface();
    const double span_u = s.breaks(0)[n.i1] - s.breaks(0)[n.i0];
    const double span_v = s.breaks(1)[n.j1] - s.breaks(1)[n.j0];
    return tree.can_split(id) && n.u1 - n.u0 > budget_.smallest * span_u &&
           n.v1 - n.v0 > budget_.smallest * span_v;
  }
  /// Cuts the node that is larger in space, or both if they are alike.
  void cut(const Pair& p, std::vector<Pair>* next) {
    const double a = size_of(first_.node(p.a).hull), b = size_of(second_.node(p.b).hull);
    const bool may_a = may_cut(first_, p.a), may_b = may_cut(second_, p.b);
    if (!may_a && !may_b) return give_up(p, OpenPair::kSmallest);
    split(p, may_a && (a > 0.6 * b || !may_b), may_b && (b > 0.6 * a || !may_a), next);
  }
  void split(const Pair& p, bool cut_a, bool cut_b, std::vector<Pair>* next) {
    const Id a = cut_a ? first_.children(p.a) : p.a, b = cut_b ? second_.children(p.b) : p.b;
    const std::uint32_t na = cut_a ? first_.num_children(p.a) : 1;
    const std::uint32_t nb = cut_b ? second_.num_children(p.b) : 1;
    const auto parent = static_cast<std::uint32_t>(cut_.size());
    cut_.push_back(p);
    for (std::uint32_t i = 0; i < na; ++i)
      for (std::uint32_t j = 0; j < nb; ++j)
        if (!is_disjoint(first_.node(a + i).hull, second_.node(b + j).hull))
          next->push_back({a + i, b + j, parent});
  }

  /// Among the pairs that this round cut, gives up the clusters of more than limit_.
  void give_up_large_clusters(std::vector<Pair>* next) {
    std::vector<Box4> boxes;
    for (const Pair& p : cut_) boxes.push_back(box_of(p));
    std::vector<char> is_given_up(cut_.size(), 0);
    for (const auto& cluster : clusters_of(boxes))
      if (cluster.size() > limit_)
        for (const std::size_t i : cluster)
          is_given_up[i] = 1, give_up(cut_[i], OpenPair::kCluster);
    std::erase_if(*next, [&](const Pair& p) { return is_given_up[p.parent] != 0; });
  }

  IntersectionBudget budget_;
  std::size_t limit_;      // of pairs in a cluster
  std::vector<Pair> cut_;  // in this round
  PatchTree first_, second_;
  IntersectionCover out_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> tubes_of_pieces_;
};

}  // namespace

std::vector<std::vector<std::size_t>> clusters_of(const std::vector<Box4>& boxes) {
  std::vector<std::size_t> order(boxes.size());
  DisjointSets<std::size_t> sets(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return boxes[i][0].lo() < boxes[j][0].lo(); });
  for (std::size_t n = 0; n < order.size(); ++n)
    for (std::size_t m = n + 1; m < order.size(); ++m) {
      if (boxes[order[m]][0].lo() > boxes[order[n]][0].hi()) break;
      if (!is_disjoint(boxes[order[n]], boxes[order[m]])) sets.join(order[n], order[m]);
    }
  std::unordered_map<std::size_t, std::size_t> number;
  std::vector<std::vector<std::size_t>> out;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto [at, is_new] = number.try_emplace(sets.find(i), out.size());
    if (is_new) out.emplace_back();
    out[at->second].push_back(i);
  }
  return out;
}

IntersectionCover cover_intersection(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                     const IntersectionBudget& budget) {
  return PairSearch(s1, s2, budget).run();
}

}  // namespace veritope
