// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/mesh_domain_test.cc: domains of meshes: their boundary and volume are the mesh's, exactly.
#include "solids/dms/domain/mesh_domain.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "solids/polyhedron/validity.h"
#include "solids/tetrahedra/delaunay.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/mesh_domain_check.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

MeshDomain made(const TriangleMesh& mesh) {
  Result<MeshDomain> domain = domain_of_mesh(mesh, {});
  if (!domain) throw std::runtime_error(to_string(domain.error()));
  return std::move(*domain);
}

void expect_domain(const TriangleMesh& mesh, const std::string& what) {
  const MeshDomain domain = made(mesh);
  EXPECT_EQ(mesh_domain_fault(mesh, domain.model), "") << what;
  if (domain.model.clouds.size() > 300) return;
  EXPECT_EQ(six_volumes(domain.model), six_volumes(mesh)) << what;
  EXPECT_TRUE(is_boundary_on_mesh(mesh, domain.model)) << what;
}

TriangleMesh schoenhardt() {
  return shapes::parse(
      "v 4,0,0 -2,3.5,0 -2,-3.5,0 3.5,2,4 -3.5,2,4 0,-4,4; "
      "f 0,2,1 3,4,5 0,1,4 0,4,3 1,2,5 1,5,4 2,0,3 2,3,5");
}

TEST(MeshDomain, FillsABoxWithoutOtherVertices) {
  const MeshDomain domain = made(shapes::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(domain.model.clouds.size(), 8u);
  EXPECT_EQ(domain.steiner_on_mesh + domain.steiner_inside, 0u);
  expect_domain(shapes::box({0, 0, 0}, {1, 1, 1}), "box");
}

TEST(MeshDomain, FillsSchoenhardtsPolyhedronWhichNeedsOtherVertices) {
  // A prism over a triangle, turned so that the diagonals of its sides go inside.
  const TriangleMesh mesh = schoenhardt();
  ASSERT_TRUE(decide_validity(mesh, {}).is_valid);
  const MeshDomain domain = made(mesh);
  EXPECT_EQ(mesh_domain_fault(mesh, domain.model), "");
  EXPECT_GT(domain.steiner_on_mesh + domain.steiner_inside, 0u);
}

TEST(MeshDomain, FillsShapesOfManyKinds) {
  expect_domain(shapes::prism(7, 2, 3), "prism");
  expect_domain(shapes::torus(9, 6, 3, 1), "torus");
  expect_domain(shapes::bipyramid(6), "bipyramid");
  expect_domain(shapes::cone(7), "cone");
  expect_domain(shapes::saddle(), "saddle");
  expect_domain(shapes::wave(8, 1), "wave");
  expect_domain(shapes::hyperboloid(8, 2), "hyperboloid");
  expect_domain(shapes::nested_boxes(4), "nested boxes");
  expect_domain(shapes::box_grid(2, 0.25), "grid of boxes");
  for (const shapes::Cap cap :
       {shapes::Cap::kCentreFan, shapes::Cap::kRimFan, shapes::Cap::kZigzag})
    expect_domain(shapes::tilted_cylinder(9, cap), "cylinder");
}

// Coplanar triangles, tunnels, and edges that no Delaunay tetrahedron has.
TEST(MeshDomain, FillsRandomSolids) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(12)); ++seed) {
    Random random(seed);
    const std::string what = "seed " + std::to_string(seed);
    expect_domain(shapes::star_polyhedron(random, 1 + static_cast<int>(random.below(2))),
                  what + " star");
    expect_domain(shapes::needles(random, 5), what + " needles");
    expect_domain(shapes::nested_scene(random, 6), what + " nested");
    const TriangleMesh cubes = shapes::random_polycube(random, 3, 12);
    if (decide_validity(cubes, {}).is_valid) expect_domain(cubes, what + " cubes");
  }
}

TEST(MeshDomain, IsExactAtTheEndsOfBinary64) {
  const TriangleMesh torus = shapes::torus(7, 5, 3, 1);
  expect_domain(shapes::scaled(torus, 900), "large");
  expect_domain(shapes::scaled(torus, -900), "small");
}

TEST(MeshDomain, RefusesMoreVerticesThanItMay) {
  const TriangleMesh mesh = shapes::torus(9, 6, 3, 1);
  MeshDomainOptions options;
  options.max_vertices = mesh.positions.size();
  const Result<MeshDomain> domain = domain_of_mesh(mesh, options);
  ASSERT_FALSE(domain.has_value());
  EXPECT_EQ(domain.error().code, Code::kOverLimit);
}

// Delaunay tetrahedra of an affine image are tetrahedra of the points, but not those of Delaunay.
TEST(MeshDomain, TakesAnyTetrahedraOfTheHull) {
  const TriangleMesh mesh = shapes::torus(9, 6, 3, 1);
  std::vector<Vec3d> image = mesh.positions;
  for (Vec3d& p : image) p.z *= 16;
  const auto delaunay = delaunay_tetrahedra(image);
  ASSERT_TRUE(delaunay.has_value());
  const Result<MeshDomain> domain = domain_of_mesh(mesh, delaunay->tetrahedra, {});
  ASSERT_TRUE(domain.has_value());
  EXPECT_EQ(mesh_domain_fault(mesh, domain->model), "");
}

TEST(MeshDomain, DoesNotTakeUnusedPositions) {
  TriangleMesh mesh = shapes::torus(5, 4, 3, 1);
  const MeshDomain plain = made(mesh);
  mesh.positions.push_back({100, 0, 0});
  EXPECT_EQ(made(mesh).model, plain.model);
}

TEST(MeshDomainCheck, NoticesDomainsThatAreNotTheMesh) {
  const TriangleMesh mesh = shapes::torus(7, 5, 3, 1);
  const MeshDomain domain = made(mesh);
  ASSERT_EQ(mesh_domain_fault(mesh, domain.model), "");
  DmsModel less = domain.model;
  less.tetrahedra.pop_back();
  EXPECT_NE(mesh_domain_fault(mesh, less), "");
  DmsModel moved = domain.model;
  moved.clouds[0][0][2] += Rational::power_of_two(-200);
  EXPECT_NE(mesh_domain_fault(mesh, moved), "");
  EXPECT_NE(mesh_domain_fault(shapes::moved(mesh, {0, 0, 1}), domain.model), "");
}

}  // namespace
}  // namespace veritope
