// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/box_tree.h"

#include <algorithm>

#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr std::uint32_t kPartDepth = 8;  // of the nodes whose self(...) is one part

void append_parts(const TreeRange& r, std::uint32_t depth, std::vector<WalkPart>& out) {
  if (depth == 0 || r.is_leaf()) {
    out.push_back({r, r});
    return;
  }
  append_parts(r.left(), depth - 1, out);
  append_parts(r.right(), depth - 1, out);
  out.push_back({r.left(), r.right()});
}

}  // namespace

BoxTree::BoxTree(const TriangleMesh& mesh, std::vector<std::uint32_t> order, const VertexStars& stars, unsigned jobs)
    : order_(std::move(order)),
      tree_(
          order_.size(), jobs, [&](std::uint32_t p) { return leaf(mesh, stars, order_[p]); }, join) {
  VT_CHECK(!order_.empty(), "facets of a box tree");
}

std::vector<WalkPart> BoxTree::parts() const {
  std::vector<WalkPart> out;
  append_parts(root(), kPartDepth, out);
  return out;
}

BoxTree::Node BoxTree::leaf(const TriangleMesh& mesh, const VertexStars& stars, std::uint32_t facet) {
  Node n;
  n.common.fill(kNone);
  std::size_t filled = 0;
  const auto& t = mesh.faces[facet];
  n.box.lo = n.box.hi = to_point(mesh.positions[t[0]]);
  for (std::uint32_t v : t) {
    add(to_point(mesh.positions[v]), &n.box);
    if (stars[v]) n.common[filled++] = v;
  }
  return n;
}

BoxTree::Node BoxTree::join(const Node& a, const Node& b) {
  Node n;
  n.box = hull(a.box, b.box);
  n.common.fill(kNone);
  std::size_t filled = 0;
  for (std::uint32_t v : a.common)
    if (v != kNone && std::find(b.common.begin(), b.common.end(), v) != b.common.end()) n.common[filled++] = v;
  return n;
}

}  // namespace veritope
