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
  if (is_new) {
    nodes_.add();
    face_of_node_.push_back(face);
    cluster_of_node_.push_back({face, 0, {}, false});
  }
  return at->second;
}

// Makes one cluster of a's and b's; returns its first node.
std::uint32_t ImproperPlaces::join(std::uint32_t a, std::uint32_t b) {
  a = nodes_.find(a), b = nodes_.find(b);
  if (a == b) return a;
  if (b < a) std::swap(a, b);
  nodes_.join(a, b);
  Cluster& kept = cluster_of_node_[a];
  const Cluster& joined = cluster_of_node_[b];
  kept.first_face = std::min(kept.first_face, joined.first_face);
  if (joined.has_box) add_to(kept, joined.pairs, joined.box);
  return a;
}

void ImproperPlaces::add_to(Cluster& cluster, std::uint64_t pairs, const Box3d& box) {
  cluster.pairs += pairs;
  cluster.box = cluster.has_box ? hull(cluster.box, box) : box;
  cluster.has_box = true;
}

void ImproperPlaces::add(std::uint32_t f, std::uint32_t g, std::uint64_t pairs) {
  const std::uint32_t a = node_of(f), b = node_of(g);
  add_to(cluster_of_node_[join(a, b)], pairs, common(box_of(*mesh_, f), box_of(*mesh_, g)));
}

void ImproperPlaces::add(const ImproperPlaces& others) {
  DisjointSets<> nodes = others.nodes_;  // a copy: find() shortens paths
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const std::uint32_t a = node_of(others.face_of_node_[i]), first = nodes.find(i);
    if (first != i) join(a, node_of(others.face_of_node_[first]));
    const Cluster& cluster = others.cluster_of_node_[i];
    if (first == i && cluster.has_box)
      add_to(cluster_of_node_[nodes_.find(a)], cluster.pairs, cluster.box);
  }
}

std::vector<ImproperPlace> ImproperPlaces::take() {
  std::unordered_map<std::uint32_t, std::uint32_t> node_at;  // of vertices
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    for (const std::uint32_t v : mesh_->faces[face_of_node_[i]]) {
      const auto [at, is_new] = node_at.try_emplace(v, i);
      if (!is_new) join(at->second, i);
    }
  std::map<std::uint32_t, ImproperPlace> by_first_face;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    const Cluster& cluster = cluster_of_node_[nodes_.find(i)];
    ImproperPlace& place = by_first_face[cluster.first_face];
    place.first_face = cluster.first_face;
    place.pairs = cluster.pairs;
    place.box = cluster.box;
    ++place.faces;
  }
  std::vector<ImproperPlace> out;
  for (auto& [face, place] : by_first_face) out.push_back(place);
  *this = ImproperPlaces(*mesh_);
  return out;
}

}  // namespace veritope
