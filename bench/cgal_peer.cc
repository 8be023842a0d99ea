// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/cgal_peer.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

namespace veritope::bench {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct CgalMesh::Impl {
  Mesh mesh;
};

CgalMesh::CgalMesh(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
  Mesh& m = impl_->mesh;
  m.reserve(static_cast<Mesh::size_type>(mesh.positions.size()),
            static_cast<Mesh::size_type>(mesh.positions.size() + mesh.faces.size()),
            static_cast<Mesh::size_type>(mesh.faces.size()));
  for (const Vec3d& p : mesh.positions) m.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
  for (const auto& f : mesh.faces)
    m.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2]));
}

CgalMesh::~CgalMesh() = default;

bool CgalMesh::is_valid_solid() const {
  const Mesh& m = impl_->mesh;
  const bool crosses = pmp::does_self_intersect<CGAL::Sequential_tag>(m);
  return CGAL::is_closed(m) && !crosses && pmp::does_bound_a_volume(m) && pmp::is_outward_oriented(m);
}

}  // namespace veritope::bench
