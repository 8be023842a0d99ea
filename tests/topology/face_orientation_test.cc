// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/face_orientation.h"

#include <gtest/gtest.h>

#include "robust/base/check.h"
#include "tests/support/shapes.h"
#include "topology/surface.h"

namespace veritope {
namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

std::optional<FaceOrientation> orient(const Faces& faces, std::uint32_t num_vertices) {
  return agreeing_orientation(faces, Incidence::build(faces, num_vertices, 1));
}

SurfaceTopology topology_of(const Faces& faces, std::uint32_t num_vertices) {
  return analyse_surface(faces, Incidence::build(faces, num_vertices, 1), 10, 1);
}

void reverse(const std::vector<bool>& which, Faces& faces) {
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (which[f]) std::swap(faces[f][1], faces[f][2]);
}

TEST(FaceOrientation, ReversesExactlyTheFacesThatDisagreeWithTheFirstOfTheirShell) {
  Random random(8801);
  for (int trial = 0; trial < 60; ++trial) {
    const TriangleMesh mesh = shapes::relabelled(
        shapes::joined(shapes::torus(5, 4, 4, 1), shapes::star_polyhedron(random, 1)), random);
    const auto num_vertices = static_cast<std::uint32_t>(mesh.positions.size());
    const SurfaceTopology as_is = topology_of(mesh.faces, num_vertices);
    ASSERT_EQ(as_is.shells.size(), 2u);
    Faces faces = mesh.faces;
    std::vector<bool> reversed;
    for (std::size_t f = 0; f < faces.size(); ++f) reversed.push_back(random.below(3) == 0);
    reverse(reversed, faces);
    const auto found = orient(faces, num_vertices);
    ASSERT_TRUE(found) << "trial " << trial;
    EXPECT_EQ(found->num_shells, 2u);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const std::uint32_t shell = as_is.shell_of_face[f];
      EXPECT_EQ(found->shell_of_face[f], shell) << "trial " << trial;
      EXPECT_EQ(found->is_reversed[f], reversed[f] != reversed[as_is.shells[shell].first_face])
          << "trial " << trial << ", face " << f;
    }
    reverse(found->is_reversed, faces);
    EXPECT_TRUE(topology_of(faces, num_vertices).is_closed_oriented_manifold());
  }
}

TEST(FaceOrientation, AOneSidedSurfaceHasNone) {
  // The projective plane with six vertices: every two of them have an edge.
  const Faces plane = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                       {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  const SurfaceTopology topology = topology_of(plane, 6);
  ASSERT_EQ(topology.boundary_edges + topology.nonmanifold_edges, 0u);
  ASSERT_EQ(topology.euler(), 1);
  EXPECT_FALSE(orient(plane, 6));
  // Beside a sphere, too.
  Faces both = {{6, 7, 8}, {6, 8, 9}, {6, 9, 7}, {7, 9, 8}};
  EXPECT_TRUE(orient(both, 10));
  both.insert(both.end(), plane.begin(), plane.end());
  EXPECT_FALSE(orient(both, 10));
}

TEST(FaceOrientation, AnEdgeWithOneFaceIsAnErrorOfTheCaller) {
  EXPECT_THROW((void)orient({{0, 1, 2}}, 3), InternalError);
}

TEST(FaceOrientation, AVertexWithManyFacesCostsNoMoreThanItsEdges) {
  const TriangleMesh mesh = shapes::bipyramid(100000);  // quadratic time would take minutes
  const auto found = orient(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()));
  ASSERT_TRUE(found);
  EXPECT_EQ(std::count(found->is_reversed.begin(), found->is_reversed.end(), true), 0);
}

}  // namespace
}  // namespace veritope
