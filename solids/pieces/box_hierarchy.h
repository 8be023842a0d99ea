// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/box_hierarchy.h: a tree over many boxes of doubles.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/box3d.h"

namespace veritope {

/// Boxes numbered from 0, halved at the median of the longest side of their centres' hull.
class BoxHierarchy {
 public:
  BoxHierarchy() = default;
  explicit BoxHierarchy(std::vector<Box3d> boxes);

  /// The numbers in an order in which neighbours are near each other.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls visit(number) for every box for which `keep` holds. REQUIRES keep(b) if b contains a box for which `keep`
  /// holds.
  template <typename Keep, typename Visit>
  void visit(Keep keep, Visit visit) const {
    if (!nodes_.empty()) visit_node(0, keep, visit);
  }

 private:
  struct Node {
    Box3d box;
    std::uint32_t lo, hi;               // positions in order_
    std::uint32_t left = 0, right = 0;  // 0: a leaf
  };
  static constexpr std::uint32_t kLeafSize = 4;
  std::uint32_t build(std::uint32_t lo, std::uint32_t hi);
  template <typename Keep, typename Visit>
  void visit_node(std::uint32_t k, Keep& keep, Visit& visit) const {
    const Node& n = nodes_[k];
    if (!keep(n.box)) return;
    if (n.left != 0) {
      visit_node(n.left, keep, visit);
      visit_node(n.right, keep, visit);
      return;
    }
    for (std::uint32_t p = n.lo; p < n.hi; ++p)
      if (keep(boxes_[order_[p]])) visit(order_[p]);
  }

  std::vector<Box3d> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace veritope
