// SPDX-License-Identifier: LGPL-3.0-or-later
// Branch and bound: nodes are boxes around patches, then patches and their halves, in the order of their bounds. Each
// carries the parts of the surface that may be nearest to it.
#include "solids/micro/inside/cell_clearance_internal.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "interval/numeric.h"
#include "solids/micro/inside/descent_internal.h"

namespace veritope::internal {
namespace {

constexpr int kMostPatchLevel = 90;

Box3 box_of_points(const std::vector<Box3>& points) {
  Box3 out = points.front();
  for (const Box3& p : points)
    for (std::size_t c = 0; c < 3; ++c) out[c] = hull(out[c], p[c]);
  return out;
}

// Coefficients for all numbers of a wall: each is a Horner sum over [lo, hi].
Box3 box_of_family(const EnclosedPatch& patch, const std::array<std::int32_t, 2>& range) {
  const Interval t = Interval::from_bounds(static_cast<double>(range[0]) * 0x1p-20,
                                           static_cast<double>(range[1]) * 0x1p-20);
  std::vector<Box3> points = patch.powers.back();
  for (std::size_t k = patch.powers.size() - 1; k-- > 0;)
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) points[i][c] = points[i][c] * t + patch.powers[k][i][c];
  return box_of_points(points);
}

class CellSearch {
 public:
  CellSearch(const PartNet& net, const PatchTree& tile, const WallNumbers& numbers,
             const DistanceParts& surface, double known, std::uint64_t most_nodes)
      : net_(net),
        tile_(tile),
        numbers_(numbers),
        surface_(surface),
        view_(surface.view()),
        most_nodes_(most_nodes) {
    out_.lo = HUGE_VAL;
    out_.hi = known;
  }

  CellClearance run() {
    if (!(out_.hi < HUGE_VAL)) reach_corners();
    if (out_.is_bounded && out_.hi < HUGE_VAL) start();
    while (out_.is_bounded && !queue_.empty()) {
      if (queue_.top().bound >= least_worth() || out_.nodes >= most_nodes_) break;
      const Node top = queue_.top();
      queue_.pop();
      if (!expand(top)) out_.lo = std::min(out_.lo, top.bound);
    }
    if (!queue_.empty()) out_.lo = std::min(out_.lo, queue_.top().bound);
    if (!(out_.hi < HUGE_VAL)) out_.is_bounded = false;
    return out_;
  }

 private:
  struct Node {
    double bound = 0;
    std::uint64_t number = 0;  // for an order that does not depend on the queue
    std::optional<std::uint32_t> of_tree;
    PatchNode patch;
    std::vector<std::uint32_t> parts;  // of the surface
  };
  struct IsFarther {
    bool operator()(const Node& a, const Node& b) const {
      return a.bound != b.bound ? a.bound > b.bound : a.number > b.number;
    }
  };

  // Bounds from here on are near enough.
  double least_worth() const { return (Interval(out_.hi) / Interval(kEnoughClearance)).lo(); }

  std::int32_t number_of_wall(const EnclosedPatch& patch) const {
    return patch.wall ? numbers_[static_cast<std::size_t>(*patch.wall)] : std::int32_t{0};
  }
  // A corner of each patch: some distances that are attained.
  void reach_corners() {
    std::vector<Box3> points;
    for (const EnclosedPatch& patch : tile_.patches()) {
      patch_points(patch, number_of_wall(patch), &points);
      const Box3 at = value(points.front());
      if (!out_.is_bounded) return;
      surface_.visit_near(
          outer_box_of(at), [&] { return out_.hi; }, [&](std::uint32_t part) { reach(part, at); });
    }
  }
  Box3 value(const Box3& at) {
    net_.part(at, at).points(&scratch_);
    for (std::size_t c = 0; c < 3; ++c)
      if (!(mag(scratch_.front()[c]) < HUGE_VAL)) out_.is_bounded = false;
    return scratch_.front();
  }
  static Box3d outer_box_of(const Box3& x) {
    return {{x[0].lo(), x[1].lo(), x[2].lo()}, {x[0].hi(), x[1].hi(), x[2].hi()}};
  }
  void reach(std::uint32_t part, const Box3& at) {
    const double distance = view_->reach(part, at);
    if (distance < out_.hi) out_.hi = distance;
  }

  void start() {
    std::vector<std::uint32_t> parts;
    const Box3 all = tile_.node(0).box;
    if (!enclose_part(all)) return;
    // Parts that are not visited are no nearer than points that are known.
    surface_.visit_near(
        points_.box, [&] { return out_.hi; }, [&](std::uint32_t part) { parts.push_back(part); });
    std::sort(parts.begin(), parts.end());
    push_tree(0, parts);
  }
  // The points of the map on a box of [0,1]^3.
  bool enclose_part(const Box3& x) {
    out_.is_bounded = net_.part(lower_ends(x), upper_ends(x)).points(&scratch_);
    if (out_.is_bounded) {
      points_.assign(scratch_);
      out_.is_bounded = is_finite(points_.box);
    }
    return out_.is_bounded;
  }

  void push_tree(std::uint32_t number, const std::vector<std::uint32_t>& parts) {
    push(tile_.node(number).box, number, {}, parts);
  }
  void push(const Box3& x, std::optional<std::uint32_t> of_tree, PatchNode patch,
            const std::vector<std::uint32_t>& from) {
    ++out_.nodes;
    if (!enclose_part(x)) return;
    Node node{HUGE_VAL, out_.nodes, of_tree, std::move(patch), {}};
    std::vector<std::uint32_t> left(from.rbegin(), from.rend());
    const double enough = least_worth(), size = extent(points_.box);
    while (!left.empty()) {
      const std::uint32_t part = left.back();
      left.pop_back();
      const double gap = view_->gap(part, points_, enough);
      if (gap >= enough) {
        out_.lo = std::min(out_.lo, gap);
        continue;
      }
      if (extent(view_->box(part)) > size)
        if (const std::uint32_t first = view_->halves(part); first != DistanceView::kNoHalves) {
          left.push_back(first + 1);
          left.push_back(first);
          continue;
        }
      node.bound = std::min(node.bound, gap);
      node.parts.push_back(part);
    }
    if (node.parts.empty()) return;
    if (!node.of_tree) {
      const Box3 at = value(node.patch.points.front());
      for (const std::uint32_t part : node.parts) reach(part, at);
    }
    queue_.push(std::move(node));
  }

  // False if there are no parts of the node.
  bool expand(const Node& node) {
    if (!node.of_tree) {
      if (node.patch.level >= kMostPatchLevel) return false;
      auto halves = node.patch.halves();
      push_patch(std::move(halves.first), node.parts);
      push_patch(std::move(halves.second), node.parts);
      return true;
    }
    const PatchTree::Node& of_tree = tile_.node(*node.of_tree);
    if (of_tree.is_leaf()) {
      const EnclosedPatch& patch = tile_.patch(of_tree.patch);
      PatchNode root{patch.degrees, {}, 0};
      patch_points(patch, number_of_wall(patch), &root.points);
      push_patch(std::move(root), node.parts);
      return true;
    }
    for (const std::uint32_t next : of_tree.next) push_tree(next, node.parts);
    return true;
  }
  void push_patch(PatchNode patch, const std::vector<std::uint32_t>& parts) {
    const Box3 x = patch.box();
    push(x, std::nullopt, std::move(patch), parts);
  }

  const PartNet& net_;
  const PatchTree& tile_;
  const WallNumbers& numbers_;
  const DistanceParts& surface_;
  std::unique_ptr<DistanceView> view_;
  std::uint64_t most_nodes_;
  CellClearance out_;
  std::priority_queue<Node, std::vector<Node>, IsFarther> queue_;
  std::vector<Box3> scratch_;
  NodePoints points_;
};

}  // namespace

PatchTree::PatchTree(const MicroTile& tile) : patches_(enclosed_patches(tile)) {
  std::vector<Box3> boxes;
  std::vector<std::uint32_t> order;
  for (const EnclosedPatch& patch : patches_) {
    order.push_back(static_cast<std::uint32_t>(order.size()));
    boxes.push_back(box_of_family(patch, tile.range.value_or(std::array<std::int32_t, 2>{0, 0})));
  }
  make(order, 0, order.size(), boxes);
}

// Halves at the median of the middles along the longest axis.
std::uint32_t PatchTree::make(std::vector<std::uint32_t>& order, std::size_t begin, std::size_t end,
                              const std::vector<Box3>& boxes) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node node;
  node.box = boxes[order[begin]];
  for (std::size_t i = begin; i < end; ++i)
    for (std::size_t c = 0; c < 3; ++c) node.box[c] = hull(node.box[c], boxes[order[i]][c]);
  node.patch = order[begin];
  nodes_.push_back(node);
  if (end - begin == 1) return number;
  std::size_t axis = 0;
  for (std::size_t c = 1; c < 3; ++c)
    if (wid(node.box[c]) > wid(node.box[axis])) axis = c;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::stable_sort(at(begin), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return mid(boxes[a][axis]) < mid(boxes[b][axis]);
  });
  const std::uint32_t low = make(order, begin, middle, boxes),
                      high = make(order, middle, end, boxes);
  nodes_[number].next = {low, high};
  return number;
}

CellClearance clearance_of_cell(const PartNet& net, const PatchTree& tile,
                                const WallNumbers& numbers, const DistanceParts& surface,
                                double known, std::uint64_t most_nodes) {
  return CellSearch(net, tile, numbers, surface, known, most_nodes).run();
}

}  // namespace veritope::internal
