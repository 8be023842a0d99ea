// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/box_hierarchy.h: closed boxes of doubles and a tree over many of them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace veritope {

using Point3d = std::array<double, 3>;
/// A closed box. No side is NaN.
struct Box3d {
  Point3d lo, hi;
};
inline bool meets(const Box3d& a, const Box3d& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.hi[k] < b.lo[k] || b.hi[k] < a.lo[k]) return false;
  return true;
}
inline bool is_inside(const Box3d& a, const Box3d& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.lo[k] < b.lo[k] || b.hi[k] < a.hi[k]) return false;
  return true;
}
inline Box3d hull(const Box3d& a, const Box3d& b) {
  Box3d out = a;
  for (std::size_t k = 0; k < 3; ++k) {
    if (b.lo[k] < out.lo[k]) out.lo[k] = b.lo[k];
    if (out.hi[k] < b.hi[k]) out.hi[k] = b.hi[k];
  }
  return out;
}
/// Of the longest side.
inline double extent(const Box3d& b) {
  double e = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (e < b.hi[k] - b.lo[k]) e = b.hi[k] - b.lo[k];
  return e;
}
/// About the middle.
inline Point3d approx_centre(const Box3d& b) {
  return {0.5 * b.lo[0] + 0.5 * b.hi[0], 0.5 * b.lo[1] + 0.5 * b.hi[1],
          0.5 * b.lo[2] + 0.5 * b.hi[2]};
}

/// Boxes numbered from 0, halved at the median of the longest side of their centres' hull.
class BoxHierarchy {
 public:
  BoxHierarchy() = default;
  explicit BoxHierarchy(std::vector<Box3d> boxes);

  /// The numbers, such that neighbours in this order are near each other.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// visit(number) for every box of which `keep` holds. REQUIRES keep(b) if b contains a box of which it holds.
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
