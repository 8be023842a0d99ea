// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_forest.h: the roots of all patches in a hierarchy of boxes, their nodes made when needed.
#pragma once
#include "star_node.h"

const uint64_t kNodesOfUnit = 32;                  // of the hierarchy
const uint64_t kNodeLimbs = sizeof(Node) / 8 + 8;  // what a node costs besides its numbers

class Forest {
 public:
  // C1, and the component of each box.
  Forest(StarBody* body, Units* units);

  // Calls visit(patch, root) for every root whose hull may meet the box with corners lo, hi
  // (possibly for some that do not) and for which leads(lo, hi) holds for all boxes on the way to
  // it.
  template <class Leads, class Visit>
  void descend(Leads leads, Visit visit) {
    std::vector<size_t> open(1, 0);
    uint64_t visited = 0;
    for (Range r; !open.empty();) {
      const size_t node = open.back();
      if (visited++ % kNodesOfUnit == 0) units_->add(1);
      open.pop_back();
      r = ranges_[node];
      if (!leads(&bounds_[6 * node], &bounds_[6 * node + 3])) continue;
      if (r.hi - r.lo == 1) {
        const uint64_t root = order_[r.lo];
        visit((*patches_)[patch_of_[root]], use(root));
        continue;
      }
      open.push_back(r.right);
      open.push_back(node + 1);
    }
  }
  Node* children(const Patch& p, Node* node) {
    if (!node->child) {
      make_children(p, node);
      for (int c = 0; c < 4; ++c) add(node->child[c].limbs());
    }
    return node->child.get();
  }
  void need_g(const Patch& p, Node* node, Node* parent);
  // What a descent keeps besides nodes, while it lives; it counts against the same limit.
  struct Held {
    Forest* forest;
    size_t limbs;
    Held(Forest* f, size_t n) : forest(f), limbs(n) { forest->add(limbs); }
    ~Held() { forest->limbs_ -= limbs + kNodeLimbs; }
    Held(const Held&) = delete;
  };
  // Calls visit(patch, node) for the leaves of trees that are read in preorder, one for each root;
  // is_leaf() reads a symbol.
  template <class IsLeaf, class Visit>
  void each_leaf(IsLeaf is_leaf, Visit visit) {
    for (uint64_t root = 0; root < patch_of_.size(); ++root) {
      each_leaf(use(root), (*patches_)[patch_of_[root]], is_leaf, visit);
      tidy();
    }
  }
  // Drops what was used least recently if there is too much. No reference to a node remains valid.
  void tidy();

 private:
  struct Range {
    uint64_t lo, hi, right;
  };
  Block root_g(const Patch& p, const Node& root);
  Node* use(uint64_t root);
  void add(size_t limbs);
  template <class IsLeaf, class Visit>
  void each_leaf(Node* node, const Patch& p, IsLeaf& is_leaf, Visit& visit) {
    if (is_leaf()) return visit(p, *node);
    Node* const child = children(p, node);
    for (int c = 0; c < 4; ++c) each_leaf(child + c, p, is_leaf, visit);
    drop_children(node);
  }
  void drop_children(Node* node);  // if there is too much
  size_t build(uint64_t lo, uint64_t hi, const std::vector<int64_t>& hulls);

  const std::vector<Patch>* patches_;
  Units* units_;
  std::vector<uint32_t> patch_of_;  // for each root
  std::vector<std::unique_ptr<Node>> roots_;
  std::vector<uint64_t> used_, order_, live_;  // used_: when last; live_: roots that are made
  std::vector<Range> ranges_;                  // the hierarchy, in preorder
  std::vector<int64_t> bounds_;
  std::vector<Block> g_;     // of each patch with several roots, once needed
  std::vector<bool> has_g_;  // whether g was needed on a patch
  uint64_t time_ = 0, limbs_ = 0;
};
