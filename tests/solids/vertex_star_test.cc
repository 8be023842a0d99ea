// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/vertex_star.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/page_star.h"
#include "tests/support/shapes.h"
#include "topology/surface.h"

namespace veritope {
namespace {

using shapes::Cap;

VertexStars stars_of(const TriangleMesh& mesh, unsigned jobs = 1) {
  const Incidence incidence = Incidence::build(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), jobs);
  const SurfaceTopology topology = analyse_surface(mesh.faces, incidence, 0, jobs);
  return find_vertex_stars(mesh, incidence, facet_signs(mesh, jobs), topology.irregular, jobs);
}

std::size_t num_stars(const VertexStars& stars) {
  return stars.code.size() - static_cast<std::size_t>(std::count(stars.code.begin(), stars.code.end(), kNoStar));
}

// Every code holds by the page's rule; if `pairs`, every two facets at a star vertex meet properly.
void expect_right(const TriangleMesh& mesh, bool pairs = true) {
  const VertexStars stars = stars_of(mesh);
  ASSERT_EQ(stars.code.size(), mesh.positions.size());
  std::map<std::uint32_t, IntVec3> own(stars.own.begin(), stars.own.end());
  EXPECT_TRUE(std::is_sorted(stars.own.begin(), stars.own.end(), [](const auto& a, const auto& b) { return a.first < b.first; }));
  std::map<std::uint32_t, std::vector<std::uint32_t>> facets_at;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    for (std::uint32_t v : mesh.faces[f]) facets_at[v].push_back(f);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const std::uint8_t code = stars.code[v];
    ASSERT_LE(code, kOwnDirection);
    EXPECT_EQ(own.count(v), code == kOwnDirection ? 1u : 0u);
    if (code == kNoStar) continue;
    const IntVec3 d = code == kOwnDirection ? own.at(v) : oracle::kPageDirections[code - 1u];
    ASSERT_EQ(oracle::judge_star(mesh, v, d), "") << "vertex " << v << ", code " << int{code} << " of " << shapes::to_text(mesh);
    if (!pairs) continue;
    const auto& at = facets_at.at(v);
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = i + 1; j < at.size(); ++j)
        ASSERT_FALSE(oracle::meet_improperly(mesh, at[i], at[j]))
            << "facets " << at[i] << " and " << at[j] << " at vertex " << v << " of " << shapes::to_text(mesh);
  }
}

// The side of a cone over a polygon that turns `turns` times around the axis, and a point below: two closed fans of `sides` facets.
TriangleMesh winding_cone(int sides, int turns, Vec3d axis_tip) {
  TriangleMesh mesh;
  mesh.positions = {axis_tip, {0, 0, -8}};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / sides, r = 2 + 0.125 * (i % 7);
    mesh.positions.push_back({r * std::cos(angle), r * std::sin(angle), 0.0625 * (i % 5)});
  }
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.faces.push_back({0, 2 + i, 2 + (i + 1) % n});
    mesh.faces.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  return mesh;
}

TEST(VertexStars, TableIsThePages) {
  for (std::size_t i = 0; i < oracle::kPageDirections.size(); ++i) EXPECT_EQ(kStarDirections[i + 1], oracle::kPageDirections[i]);
}

TEST(VertexStars, ConvexVerticesHaveOne) {
  for (const TriangleMesh& mesh : {shapes::box({0, 0, 0}, {1, 2, 3}), shapes::bipyramid(40), shapes::prism(9, 2, 5), shapes::cone(30)})
    EXPECT_EQ(num_stars(stars_of(mesh)), mesh.positions.size());
}

TEST(VertexStars, InwardSurfacesHaveThemToo) {
  const TriangleMesh mesh = shapes::reversed(shapes::bipyramid(12));
  EXPECT_EQ(num_stars(stars_of(mesh)), mesh.positions.size());
  expect_right(mesh);
}

TEST(VertexStars, ANarrowSpikeHasADirectionOfItsOwn) {
  // Eight facets around (5, 3, 1) with half an angle of 12 degrees: every direction of the table lies outside.
  TriangleMesh mesh;
  mesh.positions = {{20, 12, 4}, {-5, -3, -1}};
  for (int i = 0; i < 8; ++i) {
    const double c = 5 * std::cos(i * std::numbers::pi / 4), s = 5 * std::sin(i * std::numbers::pi / 4);
    mesh.positions.push_back({0.5145 * c + 0.1450 * s, -0.8575 * c + 0.0870 * s, -0.9856 * s});
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    mesh.faces.push_back({0, 2 + i, 2 + (i + 1) % 8});
    mesh.faces.push_back({1, 2 + (i + 1) % 8, 2 + i});
  }
  EXPECT_EQ(stars_of(mesh).code[0], kOwnDirection);
  expect_right(mesh);
}

TEST(VertexStars, AVertexThatEveryDirectionSeesFoldedHasNone) {
  const TriangleMesh mesh = shapes::saddle();
  const VertexStars stars = stars_of(mesh);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_EQ(stars.code[v] == kNoStar, (mesh.positions[v] == Vec3d{1, 1, 1})) << v;
  EXPECT_EQ(num_stars(stars), mesh.positions.size() - 1);
  expect_right(mesh);
}

TEST(VertexStars, AFlatSaddleHasOne) {
  const VertexStars stars = stars_of(shapes::wave(8, 1));
  EXPECT_NE(stars.code[0], kNoStar);
  expect_right(shapes::wave(8, 1));
}

// PROVES MESH-3
TEST(VertexStars, FansThatTurnTwiceHaveNone) {
  for (const Vec3d tip : {Vec3d{0, 0, 4}, Vec3d{3, 1, 9}, Vec3d{0.5, 0.25, -4}})
    for (const auto& [sides, turns] : {std::pair{9, 2}, std::pair{17, 2}, std::pair{16, 3}, std::pair{25, 8}}) {
      const TriangleMesh mesh = winding_cone(sides, turns, tip);
      const VertexStars stars = stars_of(mesh);
      EXPECT_EQ(stars.code[0], kNoStar) << sides << " facets, " << turns << " turns";
      EXPECT_EQ(stars.code[1], kNoStar);
      expect_right(mesh, false);
    }
  EXPECT_NE(stars_of(winding_cone(9, 1, {0, 0, 4})).code[0], kNoStar);
}

TEST(VertexStars, OpenFansHaveNone) {
  TriangleMesh mesh = shapes::bipyramid(10);
  mesh.faces.pop_back();
  const VertexStars stars = stars_of(mesh);
  EXPECT_EQ(stars.code[1], kNoStar) << "the pole that lost a facet";
  EXPECT_EQ(num_stars(stars), mesh.positions.size() - 3);
}

TEST(VertexStars, TurnedOverFacetsAndTouchingFansHaveNone) {
  TriangleMesh mesh = shapes::bipyramid(10);
  std::swap(mesh.faces[0][1], mesh.faces[0][2]);
  EXPECT_EQ(stars_of(mesh).code[0], kNoStar);
  const TriangleMesh two = shapes::parse("tet 0,0,0 1,0,0 0,1,0 0,0,1 ; tet 0,0,0 -1,0,0 0,-1,0 0,0,-1");
  EXPECT_EQ(stars_of(two).code[0], kNoStar);
  const TriangleMesh pillow = shapes::parse("v 0,0,0 1,0,0 0,1,0 ; f 0,1,2 0,2,1");
  EXPECT_EQ(num_stars(stars_of(pillow)), 0u);
}

TEST(VertexStars, DegenerateFacetsSpoilTheirVertices) {
  // A box whose corner 0 got a facet without area.
  TriangleMesh mesh = shapes::parse("v 0,0,0 2,0,0 0,2,0 0,0,2 1,0,0 ; f 0,2,1 0,4,3 4,1,3 0,1,4 1,2,3 2,0,3");
  const VertexStars stars = stars_of(mesh);
  for (std::uint32_t v : {0u, 1u, 4u}) EXPECT_EQ(stars.code[v], kNoStar);
}

// PROVES MESH-3
TEST(VertexStarsLaw, EveryCodeHoldsByThePageAndSettlesEveryPairAtItsVertex) {
  std::vector<TriangleMesh> models{shapes::box({0, 0, 0}, {1, 1, 1}, 3), shapes::torus(9, 6, 3, 1), shapes::cone(40),
                                   shapes::tilted_cylinder(20, Cap::kCentreFan), shapes::tilted_cylinder(20, Cap::kRimFan),
                                   shapes::tilted_cylinder(20, Cap::kZigzag), shapes::hyperboloid(24, 5), shapes::wave(6, 4),
                                   shapes::wave(14, 30), shapes::nested_boxes(3), shapes::bipyramid(60)};
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(12)); ++seed) {
    Random random(seed);
    models.push_back(shapes::star_polyhedron(random, 2));
    models.push_back(shapes::random_polycube(random, 3, 12));
    models.push_back(shapes::mapped(shapes::random_polycube(random, 3, 12), shapes::random_matrix(random, 3), {1, 2, 3}));
    models.push_back(shapes::mapped(shapes::saddle(), shapes::random_matrix(random, 9), {0, 0, 0}));
  }
  for (const TriangleMesh& mesh : models) {
    expect_right(mesh);
    if (HasFatalFailure()) return;
  }
}

TEST(VertexStarsLaw, EveryCodeHoldsOnSoupsThatAreNoSurface) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(200)); ++seed) {
    Random random(seed);
    // A cone over a random closed polygon: often a closed fan, rarely an embedded one.
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}, {0, 0, -1}};
    const auto n = static_cast<std::uint32_t>(3 + random.below(6));
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto c = [&] { return static_cast<double>(random.between(-3, 3)); };
      const double x = c(), y = c(), z = c();
      mesh.positions.push_back({x, y, z});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      mesh.faces.push_back({0, 2 + i, 2 + (i + 1) % n});
      mesh.faces.push_back({1, 2 + (i + 1) % n, 2 + i});
    }
    expect_right(mesh);
    if (HasFatalFailure()) return;
  }
}

TEST(VertexStarsLaw, ScalingByPowersOfTwoKeepsEveryCodeThatTheAxesGive) {
  const TriangleMesh mesh = shapes::torus(12, 8, 3, 1);
  const VertexStars one = stars_of(mesh);
  for (int e : {-900, -300, 300, 900}) {
    const VertexStars other = stars_of(shapes::scaled(mesh, e));
    for (std::size_t v = 0; v < one.code.size(); ++v)
      EXPECT_EQ(one.code[v] >= 1 && one.code[v] <= 3 ? other.code[v] : one.code[v], one.code[v]) << "2^" << e;
    expect_right(shapes::scaled(mesh, e), false);
  }
}

TEST(VertexStarsLaw, DoNotDependOnJobs) {
  const TriangleMesh mesh = shapes::mapped(shapes::torus(200, 100, 60, 20), {{{2, 1, 0}, {0, 1, 3}, {1, 0, 1}}}, {0, 0, 0});
  const VertexStars one = stars_of(mesh, 1);
  EXPECT_GT(num_stars(one), mesh.positions.size() * 99 / 100);
  for (unsigned jobs : {2u, 3u, 7u}) {
    const VertexStars many = stars_of(mesh, jobs);
    EXPECT_EQ(one.code, many.code);
    EXPECT_EQ(one.own, many.own);
  }
}

}  // namespace
}  // namespace veritope
