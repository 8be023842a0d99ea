// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/pn_model.h"

#include <string>
#include <utility>
#include <vector>

#include "io/splines/patch_model.h"
#include "robust/base/check.h"
#include "solids/patches/patch_sources.h"
#include "solids/patches/pn_mesh.h"

namespace veritope {
namespace {

Error at_corner(std::size_t face, std::uint32_t vertex, std::string message) {
  Error error{Code::kBadArgument, {}, std::move(message)};
  error.place.face = face;
  error.place.vertex = vertex;
  return error;
}

// One for each vertex; zero where no face has the vertex.
Result<std::vector<Vec3d>> vertex_normals(const TriangleMesh& mesh, const MeshNormals& normals) {
  VT_CHECK(normals.of_face.size() == mesh.faces.size(), "each face has three numbers of normals");
  std::vector<Vec3d> out(mesh.positions.size());
  std::vector<bool> is_known(out.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.faces[f][c], n = normals.of_face[f][c];
      if (n == MeshNormals::kNone)
        return at_corner(f, v, "the corner has no normal, and others have one");
      const Vec3d& normal = normals.values[n];
      if (is_known[v] && !(out[v] == normal))
        return at_corner(f, v, "the vertex has two normals that differ: the patches would not fit");
      out[v] = normal;
      is_known[v] = true;
    }
  return out;
}

Result<PnMesh<Rational>> pn_mesh_of(const MeshFile& file) {
  if (!file.normals) return make_pn_mesh(file.mesh, area_normals(file.mesh));
  const Result<std::vector<Vec3d>> normals = vertex_normals(file.mesh, *file.normals);
  if (!normals) return normals.error();
  return make_pn_mesh(file.mesh, *normals);
}

}  // namespace

Result<SplineModel> pn_model(const MeshFile& file) {
  const Result<PnMesh<Rational>> mesh = pn_mesh_of(file);
  if (!mesh) return mesh.error();
  return model_of(patches_of(*mesh));
}

}  // namespace veritope
