// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/intersection_branches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "interval/intersect/intersection_clip.h"

namespace veritope {
namespace {

double middle_of(const Interval& a) { return 0.5 * (a.lo() + a.hi()); }

/// Finds ids by cells of the first surface's parameters.
class ArcGrid {
 public:
  ArcGrid(const EnclosedSurface& s1, std::size_t num_arcs) {
    cells_ = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::sqrt(static_cast<double>(num_arcs))) * 2, 1, 1024);
    for (std::size_t i = 0; i < 2; ++i) {
      begin_[i] = s1.domain_begin(i);
      scale_[i] = static_cast<double>(cells_) / (s1.domain_end(i) - s1.domain_begin(i));
    }
    ids_.resize(cells_ * cells_);
  }
  void add(const Box4& x, std::size_t id) {
    each(x, [&](std::vector<std::size_t>& ids) { ids.push_back(id); });
  }
  /// Calls visit(id), maybe more than once, for all arcs whose boxes meet x.
  template <typename Visit>
  void find(const Box4& x, Visit visit) {
    each(x, [&](std::vector<std::size_t>& ids) {
      for (const std::size_t id : ids) visit(id);
    });
  }

 private:
  template <typename OnCell>
  void each(const Box4& x, OnCell on_cell) {
    const auto cell = [&](std::size_t i, double v) {
      const double c = (v - begin_[i]) * scale_[i];
      return static_cast<std::size_t>(std::clamp(c, 0.0, static_cast<double>(cells_ - 1)));
    };
    for (std::size_t i = cell(0, x[0].lo()); i <= cell(0, x[0].hi()); ++i)
      for (std::size_t j = cell(1, x[1].lo()); j <= cell(1, x[1].hi()); ++j)
        on_cell(ids_[i * cells_ + j]);
  }
  std::size_t cells_;
  std::array<double, 2> begin_{}, scale_{};
  std::vector<std::vector<std::size_t>> ids_;
};

class Joiner {
 public:
  Joiner(const EnclosedSurface& s1, const EnclosedSurface& s2, BranchSet* out)
      : s1_(s1), s2_(s2), out_(out), grid_(s1, out->arcs.size()) {
    const std::size_t n = out_->arcs.size();
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    holders_.resize(2 * n);
    for (std::size_t a = 0; a < n; ++a) grid_.add(range_box(a), a);
  }

  void run() {
    for (std::size_t a = 0; a < out_->arcs.size(); ++a)
      for (const bool at_end : {false, true}) link(a, at_end);
    for (const auto& [a, b, x] : maybe_)
      if (root(a) != root(b) && !share_a_point(a, b)) out_->unresolved.push_back(x);
    walk_all();
  }

 private:
  const DomainArc& arc(std::size_t a) const { return out_->arcs[a]; }
  bool is_on_border(std::size_t a, bool at_end) const {
    return at_end ? arc(a).ends_on_border : arc(a).begins_on_border;
  }
  Box4 range_box(std::size_t a) const {
    return arc(a).tube.over(Interval::from_bounds(arc(a).begin.lo(), arc(a).end.hi()));
  }
  std::size_t root(std::size_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void unite(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

  const Interval& pivot_of(const Box4& x, std::size_t a) const {
    return x[static_cast<std::size_t>(arc(a).tube.pivot)];
  }
  /// True if a common point in the box x is a point of arc a.
  bool holds(std::size_t a, const Box4& x) const {
    const Interval& w = pivot_of(x, a);
    return arc(a).begin.hi() <= w.lo() && w.hi() <= arc(a).end.lo() && arc(a).tube.contains(x);
  }
  bool may_hold(std::size_t a, const Box4& x) const {
    const Interval w =
        intersection(pivot_of(x, a), Interval::from_bounds(arc(a).begin.lo(), arc(a).end.hi()));
    return !w.is_empty() && !is_disjoint(arc(a).tube.over(w), x);
  }

  void link(std::size_t a, bool at_end) {
    if (is_on_border(a, at_end)) return;
    const Box4 x = locate(s1_, s2_, arc(a).tube, at_end ? arc(a).tube.w_hi : arc(a).tube.w_lo);
    auto& holders = holders_[2 * a + (at_end ? 1 : 0)];
    grid_.find(x, [&](std::size_t b) {
      if (b == a) return;
      if (holds(b, x)) {
        if (std::find(holders.begin(), holders.end(), b) != holders.end()) return;
        holders.push_back(b);
        unite(a, b);
      } else if (may_hold(b, x)) {
        maybe_.push_back({a, b, x});
      }
    });
    if (holders.empty()) out_->unresolved.push_back(x);
  }

  /// Tries points near a's ends: one of them in b proves that both arcs belong to one branch.
  bool share_a_point(std::size_t a, std::size_t b) {
    const double lo = arc(a).begin.hi(), hi = arc(a).end.lo();
    for (const double t : {0.001, 0.01, 0.05, 0.95, 0.99, 0.999}) {
      if (!holds(b, locate(s1_, s2_, arc(a).tube, lo + t * (hi - lo)))) continue;
      unite(a, b);
      return true;
    }
    // If no end of either arc lies in the other, they are apart.
    return is_surely_apart(a, b);
  }
  bool is_surely_apart(std::size_t a, std::size_t b) const {
    for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, a}})
      for (const bool at_end : {false, true}) {
        const DomainArc& from = arc(p);
        const Interval& w = at_end ? from.end : from.begin;
        const Box4 x =
            hull(locate(s1_, s2_, from.tube, std::clamp(w.lo(), from.tube.w_lo, from.tube.w_hi)),
                 locate(s1_, s2_, from.tube, std::clamp(w.hi(), from.tube.w_lo, from.tube.w_hi)));
        if (may_hold(q, x)) return false;
      }
    return true;
  }

  // Along n1 x n2 an arc starts at its begin if its direction is +1.
  bool starts_at_end(std::size_t a) const { return arc(a).tube.direction < 0; }
  bool starts_on_border(std::size_t a) const { return is_on_border(a, starts_at_end(a)); }
  bool finishes_on_border(std::size_t a) const { return is_on_border(a, !starts_at_end(a)); }
  double start_w(std::size_t a) const {
    return starts_at_end(a) ? arc(a).end.lo() : arc(a).begin.hi();
  }
  double finish_w(std::size_t a) const {
    return starts_at_end(a) ? arc(a).begin.hi() : arc(a).end.lo();
  }

  /// How far, in space, arc b goes on after the finish of a.
  double progress(const Box4& x, std::size_t b) const {
    const double w = middle_of(pivot_of(x, b));
    return std::abs(finish_w(b) - w) / (arc(b).tube.w_hi - arc(b).tube.w_lo) * width(range_box(b));
  }

  const std::vector<std::size_t>& start_holders(std::size_t a) const {
    return holders_[2 * a + (starts_at_end(a) ? 1 : 0)];
  }
  /// An arc at which its branch begins, or any one of a closed branch.
  std::size_t first_of(const std::vector<std::size_t>& ids) const {
    for (const bool on_border : {true, false})
      for (const std::size_t a : ids)
        if (on_border ? starts_on_border(a) : start_holders(a).empty()) return a;
    return ids.front();
  }

  void walk_all() {
    std::vector<std::vector<std::size_t>> members(parent_.size());
    for (std::size_t a = 0; a < parent_.size(); ++a) members[root(a)].push_back(a);
    for (const auto& ids : members)
      if (!ids.empty()) out_->chains.push_back(walk(first_of(ids), ids.size()));
  }

  /// Steps on to the arc that goes farthest, until the walk meets the border, an arc that was passed already, or an
  /// unknown place. A long arc may overtake the first one, so a loop closes where it meets itself.
  BranchChain walk(std::size_t first, std::size_t most) {
    const bool starts_open = !starts_on_border(first) && start_holders(first).empty();
    const bool may_close = !starts_on_border(first) && !starts_open;
    BranchChain chain;
    chain.is_partial = starts_open;
    std::size_t a = first;
    double from = start_w(first);
    Interval entry = starts_at_end(first) ? arc(first).end : arc(first).begin;
    for (std::size_t count = 0;; ++count) {
      chain.steps.push_back({a, from, finish_w(a), entry, Interval(finish_w(a))});
      if (finishes_on_border(a)) {
        chain.steps.back().exit = starts_at_end(a) ? arc(a).begin : arc(a).end;
        if (may_close) {  // a branch that ends on a border has a beginning, which was not found
          out_->unresolved.push_back(range_box(first));
          chain.is_partial = true;
        }
        return chain;
      }
      const auto& holders = holders_[2 * a + (starts_at_end(a) ? 0 : 1)];
      if (holders.empty() || count > most) {
        if (count > most) out_->unresolved.push_back(range_box(a));
        chain.is_partial = true;
        return chain;
      }
      const Box4 x = locate(s1_, s2_, arc(a).tube, finish_w(a));
      // The earliest step whose arc holds the present end; the walk before that step is not part of the loop.
      const auto met =
          std::find_if(chain.steps.begin(), chain.steps.end() - 1, [&](const BranchStep& step) {
            return std::find(holders.begin(), holders.end(), step.arc) != holders.end();
          });
      if (may_close && met != chain.steps.end() - 1) {
        chain.steps.erase(chain.steps.begin(), met);
        chain.steps.front().entry = pivot_of(x, chain.steps.front().arc);
        chain.steps.front().from = middle_of(chain.steps.front().entry);
        chain.is_closed = true;
        return chain;
      }
      std::size_t next = holders.front();
      for (const std::size_t b : holders)
        if (progress(x, b) > progress(x, next)) next = b;
      entry = pivot_of(x, next);
      from = middle_of(entry);
      a = next;
    }
  }

  struct Maybe {
    std::size_t a, b;
    Box4 x;
  };
  const EnclosedSurface &s1_, &s2_;
  BranchSet* out_;
  ArcGrid grid_;
  std::vector<std::size_t> parent_;
  std::vector<std::vector<std::size_t>> holders_;  // of the begin and the end of each arc
  std::vector<Maybe> maybe_;
};

}  // namespace

BranchSet join_branches(const EnclosedSurface& s1, const EnclosedSurface& s2,
                        const std::vector<IntersectionTube>& tubes) {
  BranchSet out;
  for (const IntersectionTube& tube : tubes)
    clip_to_domains(s1, s2, tube, &out.arcs, &out.unresolved);
  Joiner(s1, s2, &out).run();
  return out;
}

}  // namespace veritope
