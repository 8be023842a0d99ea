// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "dms_boxes.h"

#include <limits>

DmsBox::DmsBox() {
  const double far = std::numeric_limits<double>::infinity();
  std::fill(lo, lo + 3, far);
  std::fill(hi, hi + 3, -far);
}
DmsBox::DmsBox(const std::vector<const DmsPoint*>& points) : DmsBox() {
  for (const DmsPoint* p : points) add(*p);
}
void DmsBox::add(const DmsPoint& p) {
  for (int k = 0; k < 3; ++k) {
    lo[k] = std::min(lo[k], p.least(k));
    hi[k] = std::max(hi[k], p.most(k));
  }
}
void DmsBox::add(const DmsBox& b) {
  for (int k = 0; k < 3; ++k) {
    lo[k] = std::min(lo[k], b.lo[k]);
    hi[k] = std::max(hi[k], b.hi[k]);
  }
}

DmsBoxes::DmsBoxes(const std::vector<DmsBox>& list) : boxes(list) {
  for (uint32_t i = 0; i < boxes.size(); ++i) order.push_back(i);
  nodes.push_back(Node{DmsBox(), 0, uint32_t(order.size()), 0});
  for (size_t i = 0; i < nodes.size(); ++i) split(i);
}
void DmsBoxes::split(size_t at) {
  const uint32_t first = nodes[at].first, last = nodes[at].last;
  for (uint32_t i = first; i < last; ++i) nodes[at].box.add(boxes[order[i]]);
  if (last - first <= 4) return;
  const DmsBox& b = nodes[at].box;
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (b.hi[k] - b.lo[k] > b.hi[axis] - b.lo[axis]) axis = k;
  const uint32_t middle = first + (last - first) / 2;
  const auto begin = order.begin();
  const auto key = [&](uint32_t i) {  // an infinite box has its middle at 0
    const double lo = std::max(boxes[i].lo[axis], -1e308), hi = std::min(boxes[i].hi[axis], 1e308);
    return lo / 2 + hi / 2;
  };
  std::nth_element(begin + first, begin + middle, begin + last,
                   [&](uint32_t a, uint32_t c) { return key(a) < key(c); });
  nodes[at].child = uint32_t(nodes.size());
  nodes.push_back(Node{DmsBox(), first, middle, 0});
  nodes.push_back(Node{DmsBox(), middle, last, 0});
}
std::vector<uint32_t> DmsBoxes::near(const DmsBox& b) const {
  std::vector<uint32_t> r, open = {0};
  while (!open.empty()) {
    const Node& node = nodes[open.back()];
    open.pop_back();
    if (!node.box.may_meet(b)) continue;
    if (node.child != 0) {
      open.push_back(node.child);
      open.push_back(node.child + 1);
      continue;
    }
    for (uint32_t i = node.first; i < node.last; ++i)
      if (boxes[order[i]].may_meet(b)) r.push_back(order[i]);
  }
  std::sort(r.begin(), r.end());
  return r;
}

std::vector<DmsBox> dms_boxes_of_corners(const DmsModel& model) {
  std::vector<DmsBox> r(model.file.tetrahedra.size());
  for (size_t t = 0; t < r.size(); ++t)
    for (size_t c = 0; c < 4; ++c) r[t].add(model.corner(t, c));
  return r;
}
void add_dms_faces(const DmsPoint* const* corners, std::vector<DmsPlane>* planes) {
  for (const auto& f : kDmsFace)
    planes->push_back(
        DmsPlane::of(*corners[size_t(f[0])], *corners[size_t(f[1])], *corners[size_t(f[2])]));
}

DmsSides::DmsSides(std::vector<const DmsPoint*> of, const std::vector<DmsPlane>& planes,
                   bool strict)
    : corners(std::move(of)), is_strict(strict) {
  for (int k = 0; k < 3; ++k) {
    least[k] = most[k] = corners[0];
    for (const DmsPoint* p : corners) {
      if (dms_compare(*p, *least[k], k) < 0) least[k] = p;
      if (dms_compare(*p, *most[k], k) > 0) most[k] = p;
    }
    is_flat[k] = is_strict && dms_compare(*least[k], *most[k], k) == 0;
  }
  for (const DmsPlane& plane : planes) {
    const int sides = sides_of(plane);
    if (sides & 1) halves.push_back(std::make_pair(plane, -1));
    if (sides & 2) halves.push_back(std::make_pair(plane, 1));
  }
}
int DmsSides::sides_of(const DmsPlane& plane) const {
  bool above = false, below = false;
  for (const DmsPoint* p : corners) {
    const int side = plane.side(*p);
    above = above || side > 0;
    below = below || side < 0;
  }
  if (is_strict && !above && !below) return 0;
  return (below ? 0 : 1) | (above ? 0 : 2);
}
bool DmsSides::is_beside(const DmsPlane& plane) const { return sides_of(plane) != 0; }

DmsMask DmsSides::all() const {
  DmsMask r;
  const size_t bits = 6 + halves.size();
  r.first = bits >= 64 ? ~uint64_t(0) : (uint64_t(1) << bits) - 1;
  for (size_t at = 64; at < bits; at += 64)
    r.more.push_back(bits - at >= 64 ? ~uint64_t(0) : (uint64_t(1) << (bits - at)) - 1);
  return r;
}
const DmsMask& DmsSides::mask(const DmsModel& model, uint32_t point) {
  const auto found = known.find(point);
  if (found != known.end()) return found->second;
  DmsMask& r = known[point];
  r.more.assign((5 + halves.size()) / 64, 0);
  const DmsPoint& p = model.points[point];
  for (int k = 0; k < 3; ++k) {
    const int below = dms_compare(p, *least[k], k), above = dms_compare(p, *most[k], k);
    if (is_flat[k] ? below < 0 : below <= 0) r.first |= uint64_t(1) << 2 * k;
    if (is_flat[k] ? above > 0 : above >= 0) r.first |= uint64_t(2) << 2 * k;
  }
  for (size_t i = 0; i < halves.size(); ++i) {
    const size_t bit = 6 + i;
    if (halves[i].first.side(p) * halves[i].second < 0) continue;
    (bit < 64 ? r.first : r.more[bit / 64 - 1]) |= uint64_t(1) << bit % 64;
  }
  return r;
}
