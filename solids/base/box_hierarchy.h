// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/base/box_hierarchy.h: a tree over many boxes of doubles.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/base/range_tree.h"

namespace veritope {

/// Boxes numbered from 0, halved at the median of the longest side of their centres' hull.
class BoxHierarchy {
 public:
  BoxHierarchy() = default;
  explicit BoxHierarchy(const std::vector<Box3d>& boxes);

  /// The numbers in an order in which neighbours are near each other.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls visit(number) for every box for which `keep` holds. REQUIRES keep(b) if b contains a box for which `keep`
  /// holds.
  template <typename Keep, typename Visit>
  void visit(Keep keep, Visit visit) const {
    if (!tree_.is_empty()) visit_range(tree_.root(), keep, visit);
  }

 private:
  template <typename Keep, typename Visit>
  void visit_range(const TreeRange& r, Keep& keep, Visit& visit) const {
    if (!keep(tree_[r])) return;
    if (r.is_leaf()) return visit(order_[r.lo]);
    visit_range(r.left(), keep, visit);
    visit_range(r.right(), keep, visit);
  }

  std::vector<std::uint32_t> order_;
  RangeTree<Box3d> tree_;
};

}  // namespace veritope
