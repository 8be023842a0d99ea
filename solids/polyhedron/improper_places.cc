// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/improper_places.h"

#include <algorithm>
#include <map>
#include <utility>

namespace veritope {
namespace {

Box3d box_of(const TriangleMesh& mesh, std::uint32_t face) {
  const auto corner = [&](std::size_t i) {
    const Vec3d& p = mesh.positions[mesh.faces[face][i]];
    return Point3d{p.x, p.y, p.z};
  };
  Box3d out{corner(0), corner(0)};
  for (std::size_t i = 1; i < 3; ++i) out = hull(out, {corner(i), corner(i)});
  return out;
}

}  // namespace

std::uint32_t ImproperPlaces::node_of(std::uint32_t face) {
  const auto next = static_cast<std::uint32_t>(nodes_.size());
  const auto [at, is_new] = node_of_face_.try_emplace(face, next);
  if (is_new) nodes_.push_back({face, next, 0, {}, false});
  return at->second;
}

std::uint32_t ImproperPlaces::root_of(std::uint32_t node) {
  while (nodes_[node].parent != node)
    node = nodes_[node].parent = nodes_[nodes_[node].parent].parent;
  return node;
}

std::uint32_t ImproperPlaces::unite(std::uint32_t a, std::uint32_t b) {
  a = root_of(a), b = root_of(b);
  if (a == b) return a;
  if (nodes_[b].face < nodes_[a].face) std::swap(a, b);
  nodes_[b].parent = a;
  if (nodes_[b].has_box) add_to(a, nodes_[b].pairs, nodes_[b].box);
  return a;
}

void ImproperPlaces::add_to(std::uint32_t root, std::uint64_t pairs, const Box3d& box) {
  Node& node = nodes_[root];
  node.pairs += pairs;
  node.box = node.has_box ? hull(node.box, box) : box;
  node.has_box = true;
}

void ImproperPlaces::add(std::uint32_t f, std::uint32_t g) {
  const std::uint32_t a = node_of(f), b = node_of(g);
  add_to(unite(a, b), 1, common(box_of(*mesh_, f), box_of(*mesh_, g)));
}

void ImproperPlaces::add(const ImproperPlaces& others) {
  for (std::uint32_t i = 0; i < others.nodes_.size(); ++i) {
    const Node& node = others.nodes_[i];
    const std::uint32_t a = node_of(node.face);
    if (node.parent != i) unite(a, node_of(others.nodes_[node.parent].face));
    if (node.parent == i && node.has_box) add_to(root_of(a), node.pairs, node.box);
  }
}

std::vector<ImproperPlace> ImproperPlaces::take() {
  std::unordered_map<std::uint32_t, std::uint32_t> node_at;  // of vertices
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    for (const std::uint32_t v : mesh_->faces[nodes_[i].face]) {
      const auto [at, is_new] = node_at.try_emplace(v, i);
      if (!is_new) unite(at->second, i);
    }
  std::map<std::uint32_t, ImproperPlace> by_first_face;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    const Node& root = nodes_[root_of(i)];  // the least face of its cluster
    ImproperPlace& place = by_first_face[root.face];
    place.first_face = root.face;
    place.pairs = root.pairs;
    place.box = root.box;
    ++place.faces;
  }
  std::vector<ImproperPlace> out;
  for (auto& [face, place] : by_first_face) out.push_back(place);
  *this = ImproperPlaces(*mesh_);
  return out;
}

}  // namespace veritope
