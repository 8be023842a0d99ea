// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "bench/side_peers.h"

namespace veritope::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct CgalSides::Impl {
  Mesh mesh;
  std::unique_ptr<CGAL::Side_of_triangle_mesh<Mesh, Kernel>> side;
};

CgalSides::CgalSides(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
  std::vector<Mesh::Vertex_index> ids;
  for (const Vec3d& p : mesh.positions) ids.push_back(impl_->mesh.add_vertex({p.x, p.y, p.z}));
  for (const auto& f : mesh.faces) impl_->mesh.add_face(ids[f[0]], ids[f[1]], ids[f[2]]);
  impl_->side = std::make_unique<CGAL::Side_of_triangle_mesh<Mesh, Kernel>>(impl_->mesh);
  // The tree is built by the first query in its box.
  (*this)(mesh.positions[mesh.faces.front()[0]]);
}
CgalSides::~CgalSides() = default;

Side CgalSides::operator()(const Vec3d& p) const {
  switch ((*impl_->side)(Kernel::Point_3(p.x, p.y, p.z))) {
    case CGAL::ON_BOUNDED_SIDE: return Side::kIn;
    case CGAL::ON_BOUNDARY: return Side::kOn;
    default: return Side::kOut;
  }
}

}  // namespace veritope::bench
