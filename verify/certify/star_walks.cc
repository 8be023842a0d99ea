// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/star_walks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

#include "robust/base/check.h"
#include "verify/certify/walk_bounds_internal.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

constexpr int kMaxVisits = 200'000;

// Contains the part [t0, t1] of the segment a + t (b - a), 0 <= t <= 1, in the box; t0 > t1 only if that part is empty.
struct Part {
  double t0 = 0, t1 = 1;
};
Part part_in(const Box3d& box, const Point3d& a, const Point3d& b) {
  Part part;
  for (std::size_t k = 0; k < 3; ++k) {
    if (b[k] - a[k] == 0) {  // then a[k] = b[k]
      if (a[k] < box.lo[k] || a[k] > box.hi[k]) return {1, 0};
      continue;
    }
    const double s = internal::segment_parameter(box.lo[k], a[k], b[k]);
    const double t = internal::segment_parameter(box.hi[k], a[k], b[k]);
    part.t0 = std::max(part.t0, internal::parameter_below(std::min(s, t)));
    part.t1 = std::min(part.t1, internal::parameter_above(std::max(s, t)));
  }
  return part;
}

class SegmentDescent {
 public:
  SegmentDescent(PieceForest& forest, const Point3d& a, const Point3d& b)
      : forest_(forest), a_(a), b_(b) {}
  bool is_free() {
    bool free = true;
    forest_.roots().visit(
        [&](const Box3d& box) { return free && meets_segment(box); },
        [&](std::uint32_t number) { free = free && visit(forest_.root(number)); });
    return free;
  }

 private:
  bool meets_segment(const Box3d& box) const {
    const Part p = part_in(box, a_, b_);
    return p.t0 <= p.t1;
  }
  bool visit(Id id) {
    if (!meets_segment(forest_.node(id).hull)) return true;
    if (++visits_ > kMaxVisits || forest_.node(id).level >= PieceForest::kMaxLevel - 2 ||
        !forest_.may_split(id))
      return false;
    const Id first = forest_.children(id);
    for (Id k = 0; k < 4; ++k)
      if (!visit(first + k)) return false;
    return true;
  }
  PieceForest& forest_;
  const Point3d &a_, &b_;
  int visits_ = 0;
};

class WalkSearch {
 public:
  WalkSearch(PieceForest& forest, const StarCover& cover)
      : forest_(forest), cover_(cover), all_(hull_of_roots(forest)) {
    list_boxes();
  }

  ShellWalks run() {
    const std::size_t n = boxes_of_shell_.size();
    done_.assign(n, false);
    windings_.resize(n);
    const auto pass = [&](bool is_patient) {
      bool progress = false;
      for (std::uint32_t s = 0; s < n; ++s)
        if (!done_[s]) progress = walk_from(s, is_patient) || progress;
      return progress;
    };
    while (pass(false) || pass(true)) {
    }
    for (std::uint32_t s = 0; s < n; ++s)
      if (!done_[s]) out_.missing.push_back(s);
    return std::move(out_);
  }

 private:
  const Point3d& centre(std::uint32_t box, bool outside) const {
    return outside ? cover_.boxes[box].star.outside : cover_.boxes[box].star.inside;
  }

  void list_boxes() {
    shell_of_box_.assign(cover_.boxes.size(), 0);
    boxes_of_shell_.resize(forest_.complex().shells().size());
    std::vector<bool> seen(cover_.boxes.size());
    for (Id id = 0; id < cover_.box_of_node.size(); ++id) {
      const std::uint32_t box = cover_.box_of_node[id];
      if (box == StarCover::kNone || seen[box]) continue;
      seen[box] = true;
      if (!cover_.boxes[box].has_one_sheet()) continue;
      shell_of_box_[box] = forest_.complex().shell(forest_.node(id).patch);
      boxes_of_shell_[shell_of_box_[box]].push_back(box);
    }
  }

  struct Start {
    std::uint32_t box;
    bool outside;
    std::uint8_t direction;
  };
  // The patient search takes longer. It is for shells that have no walk once all others have theirs.
  bool walk_from(std::uint32_t shell, bool is_patient) {
    if (boxes_of_shell_[shell].empty()) return false;
    if (!is_patient) return walk_from_any(shell, farthest_starts(shell));
    return walk_from_any(shell, starts_at_long_boxes(shell)) || to_near_shell(shell);
  }
  bool walk_from_any(std::uint32_t shell, const std::vector<Start>& starts) {
    for (const Start& s : starts)
      if (to_infinity(shell, s.box, s.outside, s.direction)) return true;
    for (const Start& s : starts)
      if (to_other_shell(shell, s.box, s.outside, s.direction)) return true;
    return false;
  }
  // For each of six directions the farthest centre: from there a ray often reaches infinity or the next shell.
  std::vector<Start> farthest_starts(std::uint32_t shell) const {
    std::vector<Start> out;
    for (std::uint8_t direction = 0; direction < 6; ++direction) {
      const std::size_t k = direction / 2;
      const double sign = direction % 2 == 0 ? 1 : -1;
      Start best{};
      double farthest = -std::numeric_limits<double>::infinity();
      for (const std::uint32_t box : boxes_of_shell_[shell])
        for (const bool outside : {true, false}) {
          const double reach = sign * centre(box, outside)[k];
          if (reach > farthest) farthest = reach, best = {box, outside, direction};
        }
      out.push_back(best);
    }
    return out;
  }
  // The boxes whose centres are farthest apart: one of them may lie high above a sheet of a thin wall, where hulls do
  // not hide the way.
  std::vector<Start> starts_at_long_boxes(std::uint32_t shell) const {
    constexpr std::size_t kMostBoxes = 8;
    std::vector<std::pair<double, std::uint32_t>> boxes;
    for (const std::uint32_t box : boxes_of_shell_[shell])
      boxes.push_back({-distance(centre(box, true), centre(box, false)), box});
    const std::size_t count = std::min(boxes.size(), kMostBoxes);
    std::partial_sort(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(count),
                      boxes.end());
    std::vector<Start> out;
    for (std::size_t i = 0; i < count; ++i)
      for (const bool outside : {true, false})
        for (std::uint8_t direction = 0; direction < 6; ++direction)
          out.push_back({boxes[i].second, outside, direction});
    return out;
  }
  static double distance(const Point3d& p, const Point3d& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  struct Pair {
    double distance;
    std::uint32_t from, to;
    bool from_outside, to_outside;
    bool operator<(const Pair& b) const { return distance < b.distance; }
  };
  Pair pair_of(std::uint32_t from, bool from_outside, std::uint32_t to, bool to_outside) const {
    return {distance(centre(from, from_outside), centre(to, to_outside)), from, to, from_outside,
            to_outside};
  }

  // Tries the pairs of centres of this shell and of shells with walks that are nearest to each other: through a thin
  // wall a ray along an axis may miss the few boxes with one sheet.
  bool to_near_shell(std::uint32_t shell) {
    constexpr std::size_t kMostPairs = 64, kMostLookedAt = std::size_t{1} << 20;
    std::priority_queue<Pair> nearest;  // the farthest of them on top
    const auto& own = boxes_of_shell_[shell];
    for (std::uint32_t other = 0; other < boxes_of_shell_.size(); ++other) {
      const auto& others = boxes_of_shell_[other];
      if (!done_[other] || own.size() * others.size() > kMostLookedAt) continue;
      for (const std::uint32_t a : own)
        for (const std::uint32_t b : others)
          for (const bool a_outside : {false, true})
            for (const bool b_outside : {false, true}) {
              nearest.push(pair_of(a, a_outside, b, b_outside));
              if (nearest.size() > kMostPairs) nearest.pop();
            }
    }
    std::vector<Pair> pairs;
    for (; !nearest.empty(); nearest.pop()) pairs.push_back(nearest.top());
    std::reverse(pairs.begin(), pairs.end());
    for (const Pair& p : pairs) {
      if (!is_free_segment(forest_, centre(p.from, p.from_outside), centre(p.to, p.to_outside)))
        continue;
      const std::uint32_t other = shell_of_box_[p.to];
      add(ShellWalk{shell, p.from, p.from_outside, 6, p.to, p.to_outside, 0, 0, other},
          windings_[other][p.to_outside ? 1 : 0]);
      return true;
    }
    return false;
  }

  // A point of the ray beyond all hulls.
  Point3d far_point(const Point3d& from, std::uint8_t direction) const {
    Point3d to = from;
    const std::size_t k = direction / 2;
    to[k] =
        direction % 2 == 0 ? std::max(all_.hi[k], from[k]) + 1 : std::min(all_.lo[k], from[k]) - 1;
    return to;
  }

  bool to_infinity(std::uint32_t shell, std::uint32_t box, bool outside, std::uint8_t direction) {
    const Point3d& from = centre(box, outside);
    if (!is_free_segment(forest_, from, far_point(from, direction))) return false;
    add(ShellWalk{shell, box, outside, direction, 0, false, 0, 0}, 0);
    return true;
  }

  bool to_other_shell(std::uint32_t shell, std::uint32_t box, bool outside,
                      std::uint8_t direction) {
    const Point3d& from = centre(box, outside);
    for (const std::uint32_t next : boxes_along(from, far_point(from, direction))) {
      const std::uint32_t other = shell_of_box_[next];
      if (other == shell || !done_[other])
        return false;  // the first shell that the ray meets decides
      for (const bool to_outside : {true, false})
        if (is_free_segment(forest_, from, centre(next, to_outside))) {
          add(ShellWalk{shell, box, outside, 6, next, to_outside, 0, 0, other},
              windings_[other][to_outside ? 1 : 0]);
          return true;
        }
    }
    return false;
  }

  // A few boxes that cover pieces near the segment, nearest first.
  std::vector<std::uint32_t> boxes_along(const Point3d& a, const Point3d& b) {
    std::vector<std::pair<double, std::uint32_t>> found;
    const auto visit = [&](auto& self, Id id) -> void {
      const Part p = part_in(forest_.node(id).hull, a, b);
      if (p.t0 > p.t1) return;
      if (cover_.box_of_node[id] != StarCover::kNone) {
        if (!cover_.boxes[cover_.box_of_node[id]].has_one_sheet()) return;
        found.push_back({p.t0, cover_.box_of_node[id]});
        return;
      }
      const Id first = forest_.node(id).first_child;
      for (Id k = 0; first != PieceForest::kNone && k < 4; ++k) self(self, first + k);
    };
    forest_.roots().visit(
        [&](const Box3d& box) {
          const Part p = part_in(box, a, b);
          return p.t0 <= p.t1;
        },
        [&](std::uint32_t number) { visit(visit, forest_.root(number)); });
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> out;
    for (const auto& [t, box] : found)
      if (out.size() < 16 && std::find(out.begin(), out.end(), box) == out.end())
        out.push_back(box);
    return out;
  }

  void add(ShellWalk walk, int winding_at_end) {
    // w(c-) = w(c+) + 1.
    walk.winding_inside = walk.starts_outside ? winding_at_end + 1 : winding_at_end;
    walk.winding_outside = walk.winding_inside - 1;
    windings_[walk.shell] = {walk.winding_inside, walk.winding_outside};
    done_[walk.shell] = true;
    out_.walks.push_back(walk);
  }

  PieceForest& forest_;
  const StarCover& cover_;
  Box3d all_;
  ShellWalks out_;
  std::vector<bool> done_;
  std::vector<std::array<int, 2>> windings_;
  std::vector<std::uint32_t> shell_of_box_;
  std::vector<std::vector<std::uint32_t>> boxes_of_shell_;
};

}  // namespace

std::uint64_t ShellWalks::num_bodies() const {
  VT_CHECK(missing.empty(), "bodies are counted when every shell has a walk");
  std::uint64_t n = 0;
  for (const ShellWalk& w : walks) n += w.starts_outside ? 1 : 0;
  return n;
}

std::vector<std::uint32_t> shells_to_reverse(const ShellWalks& walks) {
  VT_CHECK(walks.missing.empty(), "depths are known when every shell has a walk");
  struct Nested {
    int depth = 0;
    bool is_outward = true;  // the unbounded side is the outer one
  };
  std::map<std::uint32_t, Nested> of_shell;
  std::vector<std::uint32_t> out;
  for (const ShellWalk& w : walks.walks) {
    Nested own{0, w.starts_outside};
    if (w.direction == 6) {
      const Nested& other = of_shell.at(w.end_shell);
      own.depth = other.depth + (w.ends_outside == other.is_outward ? 0 : 1);
    }
    of_shell[w.shell] = own;
    if (own.is_outward != (own.depth % 2 == 0)) out.push_back(w.shell);
  }
  std::sort(out.begin(), out.end());
  return out;
}

bool is_free_segment(PieceForest& forest, const Point3d& a, const Point3d& b) {
  return SegmentDescent(forest, a, b).is_free();
}

ShellWalks find_shell_walks(PieceForest& forest, const StarCover& cover) {
  VT_CHECK(cover.is_complete(), "walks start at boxes of a whole cover");
  return WalkSearch(forest, cover).run();
}

}  // namespace veritope
