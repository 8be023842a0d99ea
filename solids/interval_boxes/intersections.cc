// SPDX-License-Identifier: LGPL-3.0-or-later
// Pairs of boxes that meet, and all distinct intersections.
#include <algorithm>
#include <bit>
#include <unordered_map>

#include "solids/interval_boxes/box_sets_internal.h"
#include "solids/interval_boxes/conditions.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {
namespace {

struct BoxHash {
  std::size_t operator()(const std::array<double, 6>& b) const {
    std::uint64_t h = 0;
    for (const double x : b) {
      // 0 and -0 are equal.
      h = (h ^ std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h;
  }
};

std::array<double, 6> key_of(const Box3d& b) {
  return {b.lo[0], b.lo[1], b.lo[2], b.hi[0], b.hi[1], b.hi[2]};
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> meeting_pairs(std::span<const Box3d> boxes) {
  const BoxHierarchy tree({boxes.begin(), boxes.end()});
  std::vector<std::array<std::uint32_t, 2>> out;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    tree.visit([&](const Box3d& b) { return meets(b, boxes[i]); },
               [&](std::uint32_t j) {
                 if (i < j) out.push_back({i, j});
               });
  std::sort(out.begin(), out.end());
  return out;
}

DistinctIntersections distinct_intersections(std::span<const Box3d> boxes, std::size_t cap) {
  DistinctIntersections out;
  std::unordered_map<std::array<double, 6>, std::size_t, BoxHash> place;
  // For each box, the intersections so far that lie in one of its earlier neighbours and meet it: cut by the box, these
  // give all that are new with it.
  std::vector<std::vector<std::uint32_t>> earlier(boxes.size());
  for (const auto& [i, j] : meeting_pairs(boxes)) earlier[j].push_back(i);
  // Items by the last box of their set: an intersection with box j is one of a set of its earlier neighbours, cut by
  // box j.
  std::vector<std::vector<std::size_t>> with_box(boxes.size());
  const auto add = [&](const Box3d& box, std::vector<std::uint32_t> set) {
    const auto [it, is_new] = place.try_emplace(key_of(box), out.items.size());
    if (!is_new) return;
    for (const std::uint32_t k : set) with_box[k].push_back(out.items.size());
    out.items.push_back({box, std::move(set)});
  };
  for (std::uint32_t j = 0; j < boxes.size() && out.is_complete; ++j) {
    std::vector<std::size_t> near;
    for (const std::uint32_t i : earlier[j])
      near.insert(near.end(), with_box[i].begin(), with_box[i].end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    add(boxes[j], {j});
    for (const std::size_t n : near) {
      if (!meets(out.items[n].box, boxes[j])) continue;
      std::vector<std::uint32_t> set = out.items[n].boxes;
      set.push_back(j);
      add(common_part(out.items[n].box, boxes[j]), std::move(set));
    }
    if (out.items.size() > cap) out.is_complete = false;
  }
  return out;
}

}  // namespace veritope
