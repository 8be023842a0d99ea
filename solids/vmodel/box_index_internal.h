// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/box_index_internal.h: which of many boxes hold a point.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/base/range_tree.h"

namespace veritope::internal {

/// A tree of boxes, halved at the median of their middles along the longest axis.
class BoxIndex {
 public:
  BoxIndex() = default;
  explicit BoxIndex(std::vector<Box3d> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    arrange(0, order_.size());
    tree_ = RangeTree<Box3d>(
        order_.size(), 1, [&](std::size_t p) { return boxes_[order_[p]]; },
        [](const Box3d& a, const Box3d& b) { return hull(a, b); });
  }

  /// Calls use(number of the box) for boxes that hold the point, until it returns true.
  template <typename Use>
  bool each_at(const Point3d& p, const Use& use) const {
    return !tree_.is_empty() && each_at(tree_.root(), Box3d{p, p}, use);
  }

 private:
  void arrange(std::size_t lo, std::size_t hi) {
    if (hi - lo < 2) return;
    Box3d all = empty_box();
    for (std::size_t i = lo; i < hi; ++i) all = hull(all, boxes_[order_[i]]);
    std::size_t axis = 0;
    for (std::size_t c = 1; c < 3; ++c)
      if (all.hi[c] - all.lo[c] > all.hi[axis] - all.lo[axis]) axis = c;
    const auto middle = [&](std::uint32_t b) { return boxes_[b].lo[axis] + boxes_[b].hi[axis]; };
    const std::size_t half = lo + (hi - lo) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(lo), at(half), at(hi), [&](std::uint32_t a, std::uint32_t b) {
      return middle(a) < middle(b) || (middle(a) == middle(b) && a < b);
    });
    arrange(lo, half);
    arrange(half, hi);
  }
  template <typename Use>
  bool each_at(const TreeRange& r, const Box3d& p, const Use& use) const {
    if (!is_inside(p, tree_[r])) return false;
    if (r.is_leaf()) return use(order_[r.lo]);
    return each_at(r.left(), p, use) || each_at(r.right(), p, use);
  }

  std::vector<Box3d> boxes_;
  std::vector<std::uint32_t> order_;
  RangeTree<Box3d> tree_;
};

}  // namespace veritope::internal
