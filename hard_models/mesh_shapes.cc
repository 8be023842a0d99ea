// SPDX-License-Identifier: LGPL-3.0-or-later
#include <cmath>
#include <map>
#include <utility>

#include "hard_models/mesh_shapes_internal.h"

namespace veritope::hard_models::internal {
namespace {

using Face = std::array<std::uint32_t, 3>;

void reverse(std::vector<Face>& faces) {
  for (Face& face : faces) std::swap(face[1], face[2]);
}

// A polygon as a fan of triangles.
void add_fan(std::vector<Face>& faces, const std::vector<std::uint32_t>& corners) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    faces.push_back({corners[0], corners[i], corners[i + 1]});
}

}  // namespace

TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TriangleMesh box(const Vec3d& low, const Vec3d& high) {
  TriangleMesh mesh;
  for (const double z : {low.z, high.z})
    for (const double y : {low.y, high.y})
      for (const double x : {low.x, high.x}) mesh.positions.push_back({x, y, z});
  for (const std::vector<std::uint32_t>& corners : std::vector<std::vector<std::uint32_t>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    add_fan(mesh.faces, corners);
  return mesh;
}

TriangleMesh bipyramid(const Vec3d& p, const Vec3d& q) {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, q},
          {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
}

TriangleMesh spike(const Vec3d& tip) {
  return {{tip,
           {tip.x - 1, tip.y - 1, tip.z + 2},
           {tip.x + 2, tip.y - 1, tip.z + 2},
           {tip.x - 1, tip.y + 2, tip.z + 2}},
          {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
}

TriangleMesh sphere(std::uint32_t n) {
  TriangleMesh soup;
  const double step = 1.0 / n;
  for (int octant = 0; octant < 8; ++octant) {
    const double sx = (octant & 1) != 0 ? -1 : 1, sy = (octant & 2) != 0 ? -1 : 1,
                 sz = (octant & 4) != 0 ? -1 : 1;
    const bool is_mirrored = sx * sy * sz < 0;
    const auto corner = [&](std::uint32_t i, std::uint32_t j) {
      const double x = i * step, y = j * step, z = (n - i - j) * step;
      const double length = std::sqrt(x * x + y * y + z * z);
      soup.positions.push_back(
          {sx * (x / length) + 0.0, sy * (y / length) + 0.0, sz * (z / length) + 0.0});
      return static_cast<std::uint32_t>(soup.positions.size() - 1);
    };
    const auto add = [&](std::array<std::uint32_t, 6> ij) {
      Face face{corner(ij[0], ij[1]), corner(ij[2], ij[3]), corner(ij[4], ij[5])};
      if (is_mirrored) std::swap(face[1], face[2]);
      soup.faces.push_back(face);
    };
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; i + j < n; ++j) {
        add({i, j, i + 1, j, i, j + 1});
        if (i + j + 1 < n) add({i + 1, j, i + 1, j + 1, i, j + 1});
      }
  }
  return with_distinct_positions(soup);
}

TriangleMesh small_torus() {
  TriangleMesh mesh{
      {{3, -3, 0}, {3, 3, 1}, {1, 2, 3}, {-1, -2, 3}, {-3, -3, 1}, {-3, 3, 0}, {0, 0, 15}}, {}};
  for (const auto& [a, b] : {std::pair{1u, 3u}, std::pair{3u, 2u}})
    for (std::uint32_t i = 0; i < 7; ++i) mesh.faces.push_back({i, (i + a) % 7, (i + b) % 7});
  return mesh;
}

TriangleMesh frame() {
  TriangleMesh mesh;
  for (const auto& [x, y] :
       {std::pair{0.0, 0.0}, std::pair{3.0, 0.0}, std::pair{3.0, 3.0}, std::pair{0.0, 3.0}}) {
    const double inner_x = x == 0 ? 1 : 2, inner_y = y == 0 ? 1 : 2;
    for (const Vec3d& p :
         {Vec3d{x, y, 0}, Vec3d{x, y, 1}, Vec3d{inner_x, inner_y, 1}, Vec3d{inner_x, inner_y, 0}})
      mesh.positions.push_back(p);
  }
  for (std::uint32_t i = 0; i < 4; ++i)
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t a = 4 * i, b = 4 * ((i + 1) % 4), next = (k + 1) % 4;
      add_fan(mesh.faces, {a + k, b + k, b + next, a + next});
    }
  return mesh;
}

TriangleMesh placed(TriangleMesh mesh, const Vec3d& scale, const Vec3d& shift) {
  for (Vec3d& p : mesh.positions)
    p = {p.x * scale.x + shift.x, p.y * scale.y + shift.y, p.z * scale.z + shift.z};
  if ((scale.x < 0) != ((scale.y < 0) != (scale.z < 0))) reverse(mesh.faces);
  return mesh;
}

TriangleMesh reversed(TriangleMesh mesh) {
  reverse(mesh.faces);
  return mesh;
}

TriangleMesh joined(std::initializer_list<TriangleMesh> parts) {
  TriangleMesh all;
  for (const TriangleMesh& part : parts) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    for (const Face& f : part.faces)
      all.faces.push_back({first + f[0], first + f[1], first + f[2]});
  }
  return with_distinct_positions(all);
}

TriangleMesh with_distinct_positions(const TriangleMesh& mesh) {
  TriangleMesh out;
  std::map<std::array<double, 3>, std::uint32_t> ids;
  std::vector<std::uint32_t> id_of;
  for (const Vec3d& p : mesh.positions) {
    const auto next = static_cast<std::uint32_t>(out.positions.size());
    const auto [place, is_new] = ids.try_emplace({p.x, p.y, p.z}, next);
    if (is_new) out.positions.push_back(p);
    id_of.push_back(place->second);
  }
  for (const Face& f : mesh.faces) out.faces.push_back({id_of[f[0]], id_of[f[1]], id_of[f[2]]});
  return out;
}

}  // namespace veritope::hard_models::internal
