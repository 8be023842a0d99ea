// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/base/box_hierarchy.h"

#include <span>

namespace veritope {
namespace {

// Ranges of at most this many boxes are not halved further: their order stays as it is. Certificates list boxes in this
// order.
constexpr std::size_t kLeastRange = 4;

struct Centre {
  Point3d at;
  std::uint32_t number;
};

void arrange(std::span<Centre> items) {
  if (items.size() <= kLeastRange) return;
  const std::size_t middle = items.size() / 2;
  split_at_median(items, middle);
  arrange(items.first(middle));
  arrange(items.subspan(middle));
}

}  // namespace

BoxHierarchy::BoxHierarchy(const std::vector<Box3d>& boxes) {
  std::vector<Centre> items;
  for (const Box3d& box : boxes)
    items.push_back({approx_centre(box), static_cast<std::uint32_t>(items.size())});
  arrange(items);
  for (const Centre& c : items) order_.push_back(c.number);
  tree_ = RangeTree<Box3d>(
      boxes.size(), 1, [&](std::uint32_t p) { return boxes[order_[p]]; },
      [](const Box3d& a, const Box3d& b) { return hull(a, b); });
}

}  // namespace veritope
