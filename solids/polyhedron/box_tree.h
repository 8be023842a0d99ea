// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/box_tree.h: the certificate's box tree and its walk, exactly as docs/certificates/mesh.md section 5
// says.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/base/range_tree.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "solids/polyhedron/vertex_star.h"

namespace veritope {

/// One part of the walk that can be done on its own; the parts in order make up the walk.
struct WalkPart {
  TreeRange a, b;  // the same node: self(a)
};

class BoxTree {
 public:
  /// REQUIRES a non-empty order. @cost O(F) time, 128 bytes a facet.
  BoxTree(const TriangleMesh& mesh, std::vector<std::uint32_t> order, const VertexStars& stars, unsigned jobs);

  const std::vector<std::uint32_t>& order() const { return order_; }
  std::span<const std::uint32_t> facets(const TreeRange& r) const { return {order_.data() + r.lo, r.size()}; }
  TreeRange root() const { return tree_.root(); }

  /// The walk's parts in its order; they do not depend on anything but the number of facets.
  std::vector<WalkPart> parts() const;

  /// Walks one part. The visitor has
  ///   bool node_pair(a, b, k): a pair of nodes at step 3, k counted from 0 in this part; true: settled, go on after
  ///   it;
  ///   void leaf_pair(i, j): facets order()[i], order()[j] at step 4.
  ///   bool stop(): true ends the walk early.
  /// Returns the number of times that step 3 was reached.
  template <typename Visitor>
  std::uint64_t walk(const WalkPart& part, Visitor& visitor) const {
    std::uint64_t k = 0;
    if (part.a.node == part.b.node) {
      self(part.a, visitor, k);
    } else {
      cross(part.a, part.b, visitor, k);
    }
    return k;
  }

 private:
  struct Node {
    Box3d box;
    std::array<std::uint32_t, 3> common;  // star vertices of all facets below; kNone fills up
  };
  static constexpr std::uint32_t kNone = 0xffffffffu;

  static Node leaf(const TriangleMesh& mesh, const VertexStars& stars, std::uint32_t facet);
  static Node join(const Node& a, const Node& b);
  bool skips(const Node& a, const Node& b) const {
    if (!meets(a.box, b.box)) return true;
    if (a.common[0] == kNone || b.common[0] == kNone) return false;
    for (std::uint32_t v : a.common)
      for (std::uint32_t w : b.common)
        if (v == w && v != kNone) return true;
    return false;
  }
  template <typename Visitor>
  void self(const TreeRange& r, Visitor& visitor, std::uint64_t& k) const {
    if (r.is_leaf()) return;
    self(r.left(), visitor, k);
    self(r.right(), visitor, k);
    cross(r.left(), r.right(), visitor, k);
  }
  template <typename Visitor>
  void cross(const TreeRange& a, const TreeRange& b, Visitor& visitor, std::uint64_t& k) const {
    if (skips(tree_[a], tree_[b]) || visitor.stop()) return;
    if (visitor.node_pair(a, b, k++)) return;
    if (a.is_leaf() && b.is_leaf()) return visitor.leaf_pair(a.lo, b.lo);
    if (a.size() >= b.size()) {
      cross(a.left(), b, visitor, k);
      cross(a.right(), b, visitor, k);
    } else {
      cross(a, b.left(), visitor, k);
      cross(a, b.right(), visitor, k);
    }
  }

  std::vector<std::uint32_t> order_;
  RangeTree<Node> tree_;
};

}  // namespace veritope
