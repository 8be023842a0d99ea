// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/box_tree.h"

#include <algorithm>

#include "robust/base/check.h"
#include "robust/base/parallel.h"

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
    : order_(std::move(order)) {
  VT_CHECK(!order_.empty() && order_.size() < (std::size_t{1} << 30), "facets of a box tree");
  nodes_ = std::make_unique_for_overwrite<Node[]>(2 * order_.size() - 1);
  std::vector<TreeRange> above, level{root()};  // above: each node before its children
  for (int depth = 0; depth < 6 && level.front().size() > 64; ++depth) {
    std::vector<TreeRange> below;
    for (const TreeRange& r : level) {
      above.push_back(r);
      below.push_back(r.left());
      below.push_back(r.right());
    }
    level = std::move(below);
  }
  parallel_for(level.size(), 1, jobs, [&](std::size_t i, std::size_t, std::size_t) { build(mesh, stars, level[i]); });
  for (std::size_t i = above.size(); i-- > 0;) join_children(above[i]);
}

std::vector<WalkPart> BoxTree::parts() const {
  std::vector<WalkPart> out;
  append_parts(root(), kPartDepth, out);
  return out;
}

void BoxTree::build(const TriangleMesh& mesh, const VertexStars& stars, const TreeRange& r) {
  if (r.is_leaf()) return make_leaf(mesh, stars, r);
  build(mesh, stars, r.left());
  build(mesh, stars, r.right());
  join_children(r);
}

void BoxTree::make_leaf(const TriangleMesh& mesh, const VertexStars& stars, const TreeRange& r) {
  Node& n = nodes_[r.node];
  n.common.fill(kNone);
  std::size_t filled = 0;
  const auto& t = mesh.faces[order_[r.lo]];
  n.box.lo = n.box.hi = to_point(mesh.positions[t[0]]);
  for (std::uint32_t v : t) {
    add(to_point(mesh.positions[v]), &n.box);
    if (stars[v]) n.common[filled++] = v;
  }
}

void BoxTree::join_children(const TreeRange& r) {
  Node& n = nodes_[r.node];
  n.common.fill(kNone);
  std::size_t filled = 0;
  const Node &a = nodes_[r.left().node], &b = nodes_[r.right().node];
  n.box = hull(a.box, b.box);
  for (std::uint32_t v : a.common)
    if (v != kNone && std::find(b.common.begin(), b.common.end(), v) != b.common.end()) n.common[filled++] = v;
}

}  // namespace veritope
