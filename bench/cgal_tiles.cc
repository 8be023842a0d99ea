// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "bench/tile_peers.h"

namespace veritope::bench {

namespace {
using TileKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using TileMesh = CGAL::Surface_mesh<TileKernel::Point_3>;
using TileTree = CGAL::AABB_tree<
    CGAL::AABB_traits<TileKernel, CGAL::AABB_face_graph_triangle_primitive<TileMesh>>>;
TileKernel::Point_3 tile_point(const Vec3d& p) { return {p.x, p.y, p.z}; }
}  // namespace

struct CgalTiles::Impl {
  TileMesh mesh;
  TileTree tree;
  std::unique_ptr<CGAL::Side_of_triangle_mesh<TileMesh, TileKernel>> side;
};

CgalTiles::CgalTiles(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
  std::vector<TileMesh::Vertex_index> ids;
  for (const Vec3d& p : mesh.positions) ids.push_back(impl_->mesh.add_vertex(tile_point(p)));
  for (const auto& f : mesh.faces) impl_->mesh.add_face(ids[f[0]], ids[f[1]], ids[f[2]]);
  impl_->tree.insert(faces(impl_->mesh).first, faces(impl_->mesh).second, impl_->mesh);
  impl_->tree.build();
  impl_->side = std::make_unique<CGAL::Side_of_triangle_mesh<TileMesh, TileKernel>>(impl_->tree);
}
CgalTiles::~CgalTiles() = default;

PeerStatus CgalTiles::operator()(const std::vector<std::array<Vec3d, 3>>& triangles) const {
  for (const auto& t : triangles)
    if (impl_->tree.do_intersect(
            TileKernel::Triangle_3(tile_point(t[0]), tile_point(t[1]), tile_point(t[2]))))
      return PeerStatus::kCrossing;
  return (*impl_->side)(tile_point(triangles.front()[0])) == CGAL::ON_BOUNDED_SIDE
             ? PeerStatus::kInside
             : PeerStatus::kOutside;
}

}  // namespace veritope::bench
