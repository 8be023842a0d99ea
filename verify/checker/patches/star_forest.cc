// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "star_forest.h"

namespace {
const uint64_t kKeptLimbs = uint64_t(40) << 20;    // 320 MiB between boxes
const uint64_t kMostLimbs = uint64_t(160) << 20;   // 1,280 MiB within one

uint64_t limbs_below(const Node& n) {  // its own included
  uint64_t r = n.limbs() + kNodeLimbs;
  for (int c = 0; c < 4 && n.child; ++c) r += limbs_below(n.child[c]);
  return r;
}

}  // namespace

Forest::Forest(StarBody* body, Units* units)
    : patches_(&body->patches),
      units_(units),
      roots_(body->num_roots),
      used_(body->num_roots),
      g_(body->patches.size()),
      has_g_(body->patches.size()) {
  std::vector<int64_t> hulls;
  const uint32_t* symbol = body->symbols.data();
  for (uint32_t i = 0; i < body->patches.size(); ++i)
    for (uint64_t n = body->patches[i].num_roots(); n > 0; --n) {
      order_.push_back(patch_of_.size());
      patch_of_.push_back(i);
      const Hull& h = use(order_.back())->hull;
      hulls.insert(hulls.end(), h.out_lo, h.out_lo + 3);
      hulls.insert(hulls.end(), h.out_hi, h.out_hi + 3);
      tidy();
    }
  each_leaf([&] { return *symbol++ != 0; },
            [&](const Patch& p, const Node& leaf) {
              const uint32_t number = symbol[-1] - 1;
              units_->add(p.cost_of_hull(leaf.level));
              Box& b = body->boxes[number];
              const bool is_plain = b.frame == 0;
              const Hull& hull =
                  is_plain ? leaf.hull : hull_in(body->frames[b.frame], b.shift, p, leaf);
              require(hull.is_inside(b), "C1", "the hull of a leaf is not in its box", number);
              require(b.component == kNoPair || b.component == p.component || b.sheets.size() > 1,
                      "C1", "leaves of two components name the box", number);
              if (!is_plain) std::copy(leaf.hull.out_lo, leaf.hull.out_lo + 3, b.place);
              b.component = p.component;
            });
  for (size_t i = 0; i < body->boxes.size(); ++i)
    require(body->boxes[i].component != kNoPair, "C1", "no leaf names the box", i);
  if (body->num_roots > 0) build(0, body->num_roots, hulls);
}

void Forest::drop_children(Node* node) {
  if (limbs_ <= kKeptLimbs) return;
  limbs_ -= limbs_below(*node) - node->limbs() - kNodeLimbs;
  node->child.reset();
}

Node* Forest::use(uint64_t root) {
  if (!roots_[root]) {
    const Patch& p = (*patches_)[patch_of_[root]];
    roots_[root].reset(new Node(make_root(p, root - p.first_root)));
    add(roots_[root]->limbs());
    live_.push_back(root);
  }
  used_[root] = ++time_;
  return roots_[root].get();
}
void Forest::add(size_t limbs) {
  limbs_ += limbs + kNodeLimbs;
  require(limbs_ <= kMostLimbs, units_->id, "over a limit of this checker: 1,280 MiB of nodes");
}
Block Forest::root_g(const Patch& p, const Node& root) {
  const size_t patch = size_t(&p - patches_->data());
  if (!has_g_[patch]) units_->add(p.cost_of_products());
  has_g_[patch] = true;
  if (p.num_roots() == 1) return make_g(p);
  if (g_[patch].d.empty()) g_[patch] = make_g(p);
  const uint64_t i = uint64_t(root.at[0][0]) / uint64_t(kWholeSide >> p.roots[0]);
  const uint64_t j = uint64_t(root.at[0][1]) / uint64_t(kWholeSide >> p.roots[1]);
  return on_root(p, i << p.roots[1] | j, shape_of_g(p), 4, g_[patch]);
}
void Forest::need_g(const Patch& p, Node* node, Node* parent) {
  if (!node->g.d.empty()) return;
  if (parent == nullptr) {
    node->g = root_g(p, *node);
    add(node->g.d.size());
    return;
  }
  make_children_g(p, parent);
  for (int c = 0; c < 4; ++c) add(parent->child[c].g.d.size());
}
void Forest::tidy() {
  if (limbs_ <= kKeptLimbs) return;
  std::sort(live_.begin(), live_.end(),
            [&](uint64_t a, uint64_t b) { return used_[a] < used_[b]; });
  // Drops half, so that the nodes made since the last sort pay for this one.
  size_t first = live_.size();
  for (limbs_ = 0; first > 0; --first) {
    const uint64_t one = limbs_below(*roots_[live_[first - 1]]);
    if (limbs_ + one > kKeptLimbs / 2) break;
    limbs_ += one;
  }
  for (size_t i = 0; i < first; ++i) roots_[live_[i]].reset();
  live_.erase(live_.begin(), live_.begin() + int64_t(first));
}

size_t Forest::build(uint64_t lo, uint64_t hi, const std::vector<int64_t>& hulls) {
  const size_t node = ranges_.size();
  ranges_.push_back(Range{lo, hi, 0});
  bounds_.insert(bounds_.end(), 3, kFarthest);
  bounds_.insert(bounds_.end(), 3, -kFarthest);
  for (uint64_t i = lo; i < hi; ++i)
    for (size_t k = 0; k < 3; ++k) {
      const int64_t* const h = &hulls[6 * order_[i]];
      bounds_[6 * node + k] = std::min(bounds_[6 * node + k], h[k]);
      bounds_[6 * node + 3 + k] = std::max(bounds_[6 * node + 3 + k], h[3 + k]);
    }
  if (hi - lo == 1) return node;
  size_t axis = 0;
  const auto width = [&](size_t k) { return bounds_[6 * node + 3 + k] - bounds_[6 * node + k]; };
  for (size_t k = 1; k < 3; ++k)
    if (width(k) > width(axis)) axis = k;
  const uint64_t middle = lo + (hi - lo) / 2;
  std::nth_element(order_.begin() + int64_t(lo), order_.begin() + int64_t(middle),
                   order_.begin() + int64_t(hi), [&](uint64_t a, uint64_t b) {
                     return hulls[6 * a + axis] + hulls[6 * a + 3 + axis] <
                            hulls[6 * b + axis] + hulls[6 * b + 3 + axis];
                   });
  build(lo, middle, hulls);
  const size_t right = build(middle, hi, hulls);
  ranges_[node].right = right;
  return node;
}
