// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "patch_boxes.h"

namespace {

const int kBits = 60;                   // of the greatest coordinate
const int64_t kFar = int64_t(1) << 62;  // points farther away are taken there
const size_t kLeaf = 4;                 // patches of a leaf, at most

}  // namespace

void PatchBoxes::floor_and_ceiling(const Big& n, const Big& d, int64_t* floor,
                                   int64_t* ceiling) const {
  const Big x = scale_ > 0 ? shifted(n, scale_) : n, y = scale_ < 0 ? shifted(d, -scale_) : d;
  if (x.bits() - y.bits() > 61) {
    *floor = *ceiling = x.neg ? -kFar : kFar;
    return;
  }
  Big rest;
  const Big q = divide(x, y, &rest);
  const int64_t size = q.m.empty() ? 0 : int64_t(q.m[0]);
  *floor = (q.neg ? -size : size) - (rest.sign() < 0);
  *ceiling = (q.neg ? -size : size) + (rest.sign() > 0);
}

PatchBoxes::Box PatchBoxes::rounded(const Grid& grid) const {
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.lo[k] = kFar, box.hi[k] = -kFar;
    for (size_t i = 0; i < grid.net.size(); i += 4) {
      int64_t floor, ceiling;
      floor_and_ceiling(grid.net[i + size_t(k)], grid.net[i + 3], &floor, &ceiling);
      box.lo[k] = std::min(box.lo[k], floor);
      box.hi[k] = std::max(box.hi[k], ceiling);
    }
  }
  return box;
}

PatchBoxes::PatchBoxes(const std::vector<Grid>& grids) : scale_(0) {
  int64_t most = -(int64_t(1) << 40);  // bits before the point, of the greatest coordinate
  for (const Grid& g : grids)
    for (size_t i = 0; i < g.net.size(); ++i)
      if (i % 4 != 3) most = std::max(most, g.net[i].bits() - g.net[i / 4 * 4 + 3].bits());
  scale_ = kBits - most;
  for (const Grid& g : grids) {
    order_.push_back(uint32_t(boxes_.size()));
    boxes_.push_back(rounded(g));
  }
  split(0, 0, grids.size());
}

void PatchBoxes::split(size_t node, size_t lo, size_t hi) {
  if (nodes_.size() <= node) nodes_.resize(2 * node + 3);
  Box all = boxes_[order_[lo]];
  for (size_t i = lo; i < hi; ++i)
    for (int k = 0; k < 3; ++k) {
      all.lo[k] = std::min(all.lo[k], boxes_[order_[i]].lo[k]);
      all.hi[k] = std::max(all.hi[k], boxes_[order_[i]].hi[k]);
    }
  nodes_[node] = all;
  if (hi - lo <= kLeaf) return;
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (all.hi[k] / 2 - all.lo[k] / 2 > all.hi[axis] / 2 - all.lo[axis] / 2) axis = k;
  const size_t half = lo + (hi - lo) / 2;
  const auto middle = [&](uint32_t f) { return boxes_[f].lo[axis] / 2 + boxes_[f].hi[axis] / 2; };
  std::nth_element(order_.begin() + long(lo), order_.begin() + long(half),
                   order_.begin() + long(hi),
                   [&](uint32_t f, uint32_t g) { return middle(f) < middle(g); });
  split(2 * node + 1, lo, half);
  split(2 * node + 2, half, hi);
}

std::vector<uint32_t> PatchBoxes::on_ray(const RationalPoint& point, int direction) const {
  const int u = direction / 2;
  const bool is_upward = direction % 2 == 0;
  int64_t floor[3], ceiling[3];
  for (int k = 0; k < 3; ++k) floor_and_ceiling(point.n[k], point.d, &floor[k], &ceiling[k]);
  const auto misses = [&](const Box& box) {
    for (int k = 0; k < 3; ++k) {
      if (box.hi[k] < ceiling[k] && (k != u || is_upward)) return true;
      if (box.lo[k] > floor[k] && (k != u || !is_upward)) return true;
    }
    return false;
  };
  struct Range {
    size_t node, lo, hi;
  };
  std::vector<uint32_t> found;
  std::vector<Range> todo(1, Range{0, 0, order_.size()});
  while (!todo.empty()) {
    const Range r = todo.back();
    todo.pop_back();
    if (misses(nodes_[r.node])) continue;
    const size_t half = r.lo + (r.hi - r.lo) / 2;
    if (r.hi - r.lo > kLeaf) {
      todo.push_back(Range{2 * r.node + 1, r.lo, half});
      todo.push_back(Range{2 * r.node + 2, half, r.hi});
      continue;
    }
    for (size_t i = r.lo; i < r.hi; ++i)
      if (!misses(boxes_[order_[i]])) found.push_back(order_[i]);
  }
  return found;
}
