// SPDX-License-Identifier: LGPL-3.0-or-later
#include <utility>

#include "robust/base/disjoint_sets.h"
#include "solids/micro/filter/filter_model_internal.h"

namespace veritope {

TileFilter::Model::Model(const TriangleMesh& mesh, MeshClassifier classifier)
    : mesh_(&mesh), classifier_(std::move(classifier)) {
  std::vector<Box3d> boxes;
  boxes.reserve(mesh.faces.size());
  corners_.reserve(mesh.faces.size());
  for (const auto& t : mesh.faces) {
    corners_.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    Box3d box = empty_box();
    for (const Vec3d& p : corners_.back()) add(to_point(p), &box);
    boxes.push_back(box);
  }
  facet_tree_ = BoxHierarchy(boxes);
  find_shells();
}

// Faces that share a vertex belong to one shell.
void TileFilter::Model::find_shells() {
  const std::size_t n = mesh_->positions.size();
  constexpr std::uint32_t kUnused = 0xffffffffu;
  DisjointSets<> sets(n);
  std::vector<char> is_used(n);
  for (const auto& t : mesh_->faces) {
    for (const std::uint32_t v : t) is_used[v] = 1;
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<std::uint32_t> shell_of(n, kUnused), count;
  for (std::uint32_t v = 0; v < n; ++v) {
    if (is_used[v] == 0) continue;
    const std::uint32_t least = sets.find(v);
    if (least == v) {
      shell_of[v] = static_cast<std::uint32_t>(count.size());
      count.push_back(0);
    }
    shell_of[v] = shell_of[least];
    ++count[shell_of[v]];
  }
  shell_begin_.assign(1, 0);
  for (const std::uint32_t c : count) shell_begin_.push_back(shell_begin_.back() + c);
  shell_vertices_.resize(shell_begin_.back());
  std::vector<std::uint32_t> next(shell_begin_.begin(), shell_begin_.end() - 1);
  for (std::uint32_t v = 0; v < n; ++v)
    if (shell_of[v] != kUnused) shell_vertices_[next[shell_of[v]]++] = v;
  std::vector<Box3d> points;
  for (std::uint32_t s = 0; s < num_shells(); ++s) {
    const Point3d p = to_point(position(shell_vertices(s).front()));
    points.push_back({p, p});
  }
  shell_tree_ = BoxHierarchy(points);
}

}  // namespace veritope
