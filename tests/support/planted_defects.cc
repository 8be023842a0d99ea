// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/planted_defects.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tests/support/shapes.h"

namespace veritope::planted {
namespace {

using enum MeshRule;

constexpr Vec3d kToCamera{5, -8, 5}, kBehind{-5, 8, -5}, kUnder{1, 0, -9};

TriangleMesh ring() { return shapes::torus(48, 24, 3, 1); }

Vec3d middle_of(const TriangleMesh& mesh, std::size_t face) {
  Vec3d out;
  for (const std::uint32_t v : mesh.faces[face]) {
    const Vec3d& p = mesh.positions[v];
    out = {out.x + p.x / 3, out.y + p.y / 3, out.z + p.z / 3};
  }
  return out;
}
// The face that lies farthest in a direction.
std::size_t face_toward(const TriangleMesh& mesh, const Vec3d& d) {
  std::size_t best = 0;
  double most = -HUGE_VAL;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Vec3d m = middle_of(mesh, f);
    const double height = m.x * d.x + m.y * d.y + m.z * d.z;
    if (height > most) most = height, best = f;
  }
  return best;
}

std::uint32_t added_point(TriangleMesh& mesh, const Vec3d& p) {
  mesh.positions.push_back(p);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

TriangleMesh with_crack(TriangleMesh mesh, const Vec3d& where) {
  auto& face = mesh.faces[face_toward(mesh, where)];
  Vec3d moved = mesh.positions[face[0]];
  moved.x = std::nextafter(moved.x, HUGE_VAL);
  face[0] = added_point(mesh, moved);
  return mesh;
}
TriangleMesh with_hole(TriangleMesh mesh, const Vec3d& where) {
  mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(face_toward(mesh, where)));
  return mesh;
}
// A tetrahedron through the middle of a face.
TriangleMesh with_crossing(const TriangleMesh& mesh, const Vec3d& where, double size) {
  const Vec3d m = middle_of(mesh, face_toward(mesh, where));
  TriangleMesh tetrahedron;
  for (const auto& [x, y, z] : {std::array{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
    tetrahedron.positions.push_back({m.x + size * x, m.y + size * y, m.z + size * z});
  tetrahedron.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return shapes::joined(mesh, tetrahedron);
}
// A tetrahedron that stands on a vertex of the mesh.
TriangleMesh with_touching_vertex(TriangleMesh mesh, const Vec3d& where, double size) {
  const std::uint32_t v = mesh.faces[face_toward(mesh, where)][0];
  const Vec3d p = mesh.positions[v];
  const double length = std::sqrt(where.x * where.x + where.y * where.y + where.z * where.z);
  const Vec3d out{where.x / length, where.y / length, where.z / length};
  std::array<std::uint32_t, 3> base{};
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3d q{p.x + size * out.x, p.y + size * out.y, p.z + size * out.z};
    (i == 0 ? q.x : i == 1 ? q.y : q.z) += size / 8;
    base[i] = added_point(mesh, q);
  }
  const auto [a, b, c] = base;
  for (const auto& f : {std::array{v, b, a}, {v, c, b}, {v, a, c}, {a, b, c}})
    mesh.faces.push_back(f);
  return mesh;
}
TriangleMesh with_copy(TriangleMesh mesh, const Vec3d& where) {
  mesh.faces.push_back(mesh.faces[face_toward(mesh, where)]);
  return mesh;
}
TriangleMesh with_turned_face(TriangleMesh mesh, const Vec3d& where) {
  auto& face = mesh.faces[face_toward(mesh, where)];
  std::swap(face[0], face[1]);
  return mesh;
}
TriangleMesh with_needle(TriangleMesh mesh, const Vec3d& where) {
  const auto [a, b, c] = mesh.faces[face_toward(mesh, where)];
  mesh.faces.push_back({a, b, b});
  return mesh;
}
TriangleMesh with_many_holes(TriangleMesh mesh) {
  TriangleMesh out = mesh;
  out.faces.clear();
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (f % 11 != 0) out.faces.push_back(mesh.faces[f]);
  return out;
}
TriangleMesh long_box(const Vec3d& hi) { return shapes::box({0, 0, 0}, hi, 2); }

// Two boxes with a common edge.
TriangleMesh at_one_edge() { return shapes::parse("box 0,0,0 1,1,1 ; box 1,1,0 2,2,1"); }

// A beam along the view, whose end away from the camera is open.
TriangleMesh beam_along_the_view() {
  TriangleMesh mesh = shapes::prism(12, 0.05, 1);
  const double length = std::sqrt(114.0);
  const Vec3d z{-5 / length, 8 / length, -5 / length};
  const double side = std::sqrt(89.0);
  const Vec3d x{8 / side, 5 / side, 0};
  const Vec3d y{z.y * x.z - z.z * x.y, z.z * x.x - z.x * x.z, z.x * x.y - z.y * x.x};
  for (Vec3d& p : mesh.positions)
    p = {p.x * x.x + p.y * y.x + 9 * p.z * z.x, p.x * x.y + p.y * y.y + 9 * p.z * z.y,
         p.x * x.z + p.y * y.z + 9 * p.z * z.z};
  mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(face_toward(mesh, z)));
  return mesh;
}

TriangleMesh turned_shells() {
  return shapes::joined(ring(), shapes::moved(shapes::scaled(ring(), -3), {3, 0, 0}));
}

}  // namespace

std::vector<MeshModel> meshes() {
  const TriangleMesh body = ring();
  return {
      {"a crack of one ulp", with_crack(body, kToCamera), {kM3}},
      {"a crack of one ulp behind the model", with_crack(body, kBehind), {kM3}},
      {"a hole", with_hole(body, kToCamera), {kM3}},
      {"a hole in a far corner", with_hole(long_box({100, 1, 1}), {1, 1, -1}), {kM3}},
      {"a tiny crossing", with_crossing(body, kToCamera, 1e-6), {kM7}},
      {"a tiny crossing under the model", with_crossing(body, kUnder, 1e-6), {kM7}},
      {"a self-touching vertex", with_touching_vertex(body, kToCamera, 1e-3), {kM6}},
      {"a self-touching vertex behind the model", with_touching_vertex(body, kBehind, 1e-3), {kM6}},
      {"two bodies that cross, and a hole",
       with_hole(shapes::joined(body, shapes::moved(body, {3, 1, 0.3})), kUnder),
       {kM3, kM7}},
      {"a face twice", with_copy(body, kBehind), {kM2, kM4, kM7}},
      {"a face without area", with_needle(body, kToCamera), {kM1}},
      {"an edge with four faces", at_one_edge(), {kM4}},
      {"a face that is turned over", with_turned_face(body, kUnder), {kM5}},
      {"inside out", shapes::reversed(body), {kM8}},
      {"a shell in a body faces outward", turned_shells(), {kM9}},
      {"a tiny shell in a body faces outward",
       shapes::joined(
           body, shapes::moved(shapes::scaled(shapes::box({0, 0, 0}, {1, 1, 1}), -20), {-3, 0, 0})),
       {kM9}},
      {"four defects at one place",
       with_copy(with_touching_vertex(with_crossing(body, kToCamera, 1e-6), kToCamera, 1e-3),
                 kToCamera),
       {kM2, kM4, kM6, kM7}},
      {"a tiny crossing among two hundred holes",
       with_crossing(with_many_holes(body), kToCamera, 1e-6),
       {kM3, kM6, kM7}},
      {"a crack far from the origin",
       with_crack(shapes::moved(body, {1 << 20, 1 << 20, 1 << 20}), kBehind),
       {kM3}},
      {"an open beam that is seen from its end", beam_along_the_view(), {kM3}},
  };
}

}  // namespace veritope::planted
