// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/box_hierarchy.h"

#include <algorithm>
#include <numeric>

namespace veritope {

BoxHierarchy::BoxHierarchy(std::vector<Box3d> boxes)
    : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t BoxHierarchy::build(std::uint32_t lo, std::uint32_t hi) {
  Box3d box = boxes_[order_[lo]];
  const Point3d first = approx_centre(box);
  Box3d centres{first, first};
  for (std::uint32_t p = lo + 1; p < hi; ++p) {
    box = hull(box, boxes_[order_[p]]);
    add(approx_centre(boxes_[order_[p]]), &centres);
  }
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({box, lo, hi});
  if (hi - lo <= kLeafSize) return number;
  const std::size_t axis = longest_axis(centres);
  const std::uint32_t middle = lo + (hi - lo) / 2;
  const auto key = [&](std::uint32_t i) { return approx_centre(boxes_[i])[axis]; };
  std::nth_element(
      order_.begin() + lo, order_.begin() + middle, order_.begin() + hi,
      [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  const std::uint32_t left = build(lo, middle), right = build(middle, hi);
  nodes_[number].left = left, nodes_[number].right = right;
  return number;
}

}  // namespace veritope
