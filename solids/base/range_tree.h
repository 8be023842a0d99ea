// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/base/range_tree.h: the one binary tree over items: ranges of an order, halved by position, a node each. What a
// node holds is the user's: a box, or a box and what all items below have in common.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"

namespace veritope {

/// A node: positions [lo, hi) of the order. Children halve it; nodes are numbered in preorder.
struct TreeRange {
  std::uint32_t node, lo, hi;
  std::uint32_t size() const { return hi - lo; }
  bool is_leaf() const { return hi - lo == 1; }
  TreeRange left() const { return {node + 1, lo, lo + (hi - lo) / 2}; }
  TreeRange right() const {
    const std::uint32_t mid = lo + (hi - lo) / 2;
    return {node + 2 * (mid - lo), mid, hi};
  }
};

template <typename Node>
class RangeTree {
 public:
  RangeTree() = default;
  /// leaf(p) is the node of position p, join(a, b) the node whose children are a and b. The result does not depend on
  /// jobs. REQUIRES fewer than 2^30 items.
  template <typename Leaf, typename Join>
  RangeTree(std::size_t num_items, unsigned jobs, const Leaf& leaf, const Join& join);

  bool is_empty() const { return num_items_ == 0; }
  /// REQUIRES !is_empty().
  TreeRange root() const { return {0, 0, num_items_}; }
  const Node& operator[](const TreeRange& r) const { return nodes_[r.node]; }

 private:
  template <typename Leaf, typename Join>
  void build(const TreeRange& r, const Leaf& leaf, const Join& join) {
    if (r.is_leaf()) {
      nodes_[r.node] = leaf(r.lo);
      return;
    }
    build(r.left(), leaf, join);
    build(r.right(), leaf, join);
    nodes_[r.node] = join(nodes_[r.left().node], nodes_[r.right().node]);
  }

  std::uint32_t num_items_ = 0;
  std::unique_ptr<Node[]> nodes_;
};

template <typename Node>
template <typename Leaf, typename Join>
RangeTree<Node>::RangeTree(std::size_t num_items, unsigned jobs, const Leaf& leaf,
                           const Join& join) {
  VT_CHECK(num_items < (std::size_t{1} << 30), "items of a tree");
  num_items_ = static_cast<std::uint32_t>(num_items);
  if (is_empty()) return;
  nodes_ = std::make_unique_for_overwrite<Node[]>(2 * num_items - 1);
  std::vector<TreeRange> above, level{root()};  // above: each node before its children
  for (int depth = 0; depth < 6 && level.front().size() > 64; ++depth) {
    std::vector<TreeRange> below;
    for (const TreeRange& r : level) {
      above.push_back(r);
      below.push_back(r.left());
      below.push_back(r.right());
    }
    level = std::move(below);
  }
  parallel_for(level.size(), 1, jobs,
               [&](std::size_t i, std::size_t, std::size_t) { build(level[i], leaf, join); });
  for (std::size_t i = above.size(); i-- > 0;)
    nodes_[above[i].node] = join(nodes_[above[i].left().node], nodes_[above[i].right().node]);
}

/// Moves the items so that the first `middle` ones are those with the least centres along the longest side of the box
/// of all centres, ties by number. An Item has a centre, `at`, and a `number`. REQUIRES middle < items.size().
template <typename Item>
void split_at_median(std::span<Item> items, std::size_t middle) {
  Box3d centres{items[0].at, items[0].at};
  for (const Item& item : items) add(item.at, &centres);
  const std::size_t axis = longest_axis(centres);
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                   [axis](const Item& a, const Item& b) {
                     return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis]
                                                     : a.number < b.number;
                   });
}

}  // namespace veritope
